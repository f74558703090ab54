package handover.tabular;

/**
 * Bounds on the value of every belief that were found by an earlier search: vectors from below, single beliefs from above. Immutable,
 * thread safe.
 */
final class Learned {
    private final InitialBounds bounds;
    private final Alphas vectors;
    private final double[][] belief;
    private final double[] bound;

    /**
     * @param vectors from below; not modified any more, likewise the other arrays
     * @param belief by point, then state
     * @param bound upper bound at each point
     */
    Learned(InitialBounds bounds, Alphas vectors, double[][] belief, double[] bound) {
        this.bounds = bounds;
        this.vectors = vectors;
        this.belief = belief;
        this.bound = bound;
    }

    /** Nothing but what follows from the model alone. */
    static Learned nothing(TabularPomdp m) {
        InitialBounds bounds = new InitialBounds(m);
        return new Learned(bounds, bounds.lower(), new double[0][], new double[0]);
    }

    InitialBounds bounds() {
        return bounds;
    }

    Alphas vectors() {
        return vectors;
    }

    /** How many beliefs have an upper bound of their own. */
    int size() {
        return belief.length;
    }

    /** Not to be modified. */
    double[] belief(int k) {
        return belief[k];
    }

    double bound(int k) {
        return bound[k];
    }
}
