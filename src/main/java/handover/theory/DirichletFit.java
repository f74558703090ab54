package handover.theory;

import org.hipparchus.special.Gamma;

/** Dirichlet parameters from moments. */
final class DirichletFit {
    /** A total variance below this is rounding: a point mass. */
    static final double NO_VARIANCE = 1e-13;

    private static final double TINIEST = 1e-9;
    private static final double LARGEST = 1e9;

    private DirichletFit() {}

    /** alpha_0 = (1 - q) / (q - ||m||^2); infinite for a point mass, 0 for a mixture of vertices. */
    static double concentration(Moments moments) {
        double variance = moments.square() - moments.meanSquared();
        return variance <= NO_VARIANCE ? Double.POSITIVE_INFINITY : Math.max(0, (1 - moments.square()) / variance);
    }

    /**
     * alpha with psi(alpha_j) - psi(alpha_0) = g_j. For a given alpha_0 each alpha_j follows, so that one unknown is
     * left; the surplus sum_j alpha_j(alpha_0) - alpha_0 changes its sign once, and bisection in log alpha_0 cannot fail.
     *
     * @param meanLog g_j = E[log beta_j], finite; not modified
     * @return alpha; null if it is a point mass to rounding (alpha_0 would exceed 1e9)
     */
    static double[] fromMeanLog(double[] meanLog) {
        double low = Math.log(TINIEST);
        double high = Math.log(LARGEST);
        if (surplus(meanLog, high) > 0) {
            return null;
        }
        while (high - low > 1e-13 * Math.max(1, Math.abs(high))) {
            double middle = (low + high) / 2;
            if (surplus(meanLog, middle) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return alpha(meanLog, high);
    }

    private static double surplus(double[] meanLog, double logTotal) {
        double s = -Math.exp(logTotal);
        for (double a : alpha(meanLog, logTotal)) {
            s += a;
        }
        return s;
    }

    private static double[] alpha(double[] meanLog, double logTotal) {
        double psi = Digamma.of(Math.exp(logTotal));
        double[] alpha = new double[meanLog.length];
        for (int j = 0; j < alpha.length; j++) {
            alpha[j] = inverseDigamma(psi + meanLog[j]);
        }
        return alpha;
    }

    /** The x &gt; 0 with psi(x) = {@code y}, by Newton's method from Minka's starting point (appendix C). */
    static double inverseDigamma(double y) {
        double x = y >= -2.22 ? Math.exp(y) + 0.5 : -1 / (y - Digamma.of(1));
        for (int k = 0; k < 8; k++) {
            double step = (Digamma.of(x) - y) / Gamma.trigamma(x);
            x = Math.max(x / 8, x - step);
            if (Math.abs(step) < 1e-15 * x) {
                break;
            }
        }
        return x;
    }
}
