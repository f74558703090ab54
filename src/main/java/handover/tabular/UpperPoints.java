package handover.tabular;

import java.util.Arrays;

/**
 * Beliefs whose value is known to be below what the fast informed bound says. Because the value is convex, each of them lowers
 * the bound of the beliefs around it: the sawtooth projection. Used by one thread.
 *
 * <p>Source: Hauskrecht 2000, on sawtooth projections, as used in HSVI (Smith and Simmons 2005).
 */
final class UpperPoints {
    private final BeliefStore beliefs;
    /** The bound at each certain belief. */
    private final double[] corner;
    private int[] node = new int[64];
    /** How far the bound lies below the plane through the corners. */
    private double[] drop = new double[64];
    private int size;

    UpperPoints(BeliefStore beliefs, double[] corner) {
        this.beliefs = beliefs;
        this.corner = corner;
    }

    void clear() {
        size = 0;
    }

    int size() {
        return size;
    }

    /** Adds belief {@code k} with this bound and gives its place. */
    int add(int k, double bound) {
        if (size == node.length) {
            node = Arrays.copyOf(node, 2 * size);
            drop = Arrays.copyOf(drop, 2 * size);
        }
        node[size] = k;
        drop[size] = bound - plane(k);
        return size++;
    }

    /** The belief at a place. */
    int node(int place) {
        return node[place];
    }

    /** Lowers the bound of the point at a place. */
    void lower(int place, double bound) {
        drop[place] = bound - plane(node[place]);
    }

    private double plane(int k) {
        return beliefs.dot(k, corner, 0);
    }

    /**
     * The bound at belief {@code k} by all points from {@code first} on.
     *
     * @param dense the same belief as an array; not modified
     */
    double bound(int k, double[] dense, int first) {
        double best = 0;
        int[] states = beliefs.states();
        double[] p = beliefs.probabilities();
        for (int i = first; i < size; i++) {
            double ratio = 1;
            double enough = drop[i] < 0 ? best / drop[i] : 1;
            int end = beliefs.begin(node[i] + 1);
            for (int j = beliefs.begin(node[i]); j < end && ratio > enough; j++) {
                double b = dense[states[j]];
                if (b < ratio * p[j]) {
                    ratio = b / p[j];
                }
            }
            best = ratio > enough ? ratio * drop[i] : best;
        }
        return plane(k) + best;
    }
}
