package handover.theory;

/** Checks of vectors where they enter the package. */
final class Weights {
    /** By how much the sum of a distribution that is handed in may miss 1. */
    private static final double SUM_TOLERANCE = 1e-9;

    private Weights() {}

    /** A copy of {@code w}. Throws {@link IllegalArgumentException} unless it has entries, all finite and not negative. */
    static double[] checked(String name, double[] w) {
        if (w.length == 0) {
            throw new IllegalArgumentException(name + ": expected at least one entry, got none");
        }
        for (int i = 0; i < w.length; i++) {
            if (!(w[i] >= 0 && w[i] < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(name + "[" + i + "]: expected a finite number >= 0, got " + w[i]);
            }
        }
        return w.clone();
    }

    /**
     * A copy of {@code p}. Throws {@link IllegalArgumentException} unless it is a distribution (its sum within 1e-9 of
     * 1).
     */
    static double[] distribution(String name, double[] p) {
        double[] copy = checked(name, p);
        double s = 0;
        for (double x : copy) {
            s += x;
        }
        if (Math.abs(s - 1) > SUM_TOLERANCE) {
            throw new IllegalArgumentException(name + ": expected entries that sum to 1, got the sum " + s);
        }
        return copy;
    }

    /** Throws {@link IllegalArgumentException} unless both are {@code n}. */
    static void sameSize(String name, int expected, int got) {
        if (expected != got) {
            throw new IllegalArgumentException(name + ": expected " + expected + " objects, got " + got);
        }
    }

    /** {@code p} unless it is no probability, then {@link IllegalArgumentException}. */
    static double probability(String name, double p) {
        if (!(p >= 0 && p <= 1)) {
            throw new IllegalArgumentException(name + ": expected a probability, got " + p);
        }
        return p;
    }
}
