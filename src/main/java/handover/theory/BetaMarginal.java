package handover.theory;

import java.util.function.DoubleUnaryOperator;
import org.hipparchus.special.Beta;
import org.hipparchus.special.Gamma;

/**
 * One entry beta_j of a Dirichlet belief: Beta(a, b) with a = alpha_0 m, b = alpha_0 (1 - m), or its limits, a point
 * (alpha_0 infinite) and two vertices (alpha_0 = 0). Immutable, thread safe.
 *
 * @param mean m in [0, 1]
 * @param concentration alpha_0 in [0, infinity]
 */
record BetaMarginal(double mean, double concentration) {
    private static final double NEGLIGIBLE = 39;
    /** Beyond this logit x is 0 or 1 to rounding. */
    private static final double EDGE = 45;
    /** Above this the variance is below rounding. */
    private static final double POINT = 1e12;

    private boolean point() {
        return !(mean > 0) || mean >= 1 || concentration > POINT;
    }

    /**
     * E[f(x)], by the trapezoidal rule in the logit u = log(x / (1-x)), in which the density is
     * sigma(u)^a sigma(-u)^b / B(a, b), smooth and log-concave whatever a and b; exponential tails are summed as geometric
     * series. About 1e-12 for an f that is analytic near [0, 1].
     */
    double expectation(DoubleUnaryOperator f) {
        if (point()) {
            return f.applyAsDouble(Math.min(1, mean));
        }
        if (concentration == 0) {
            return mean * f.applyAsDouble(1) + (1 - mean) * f.applyAsDouble(0);
        }
        double a = concentration * mean;
        double b = concentration * (1 - mean);
        double step = Math.min(0.25, Math.sqrt(Gamma.trigamma(a) + Gamma.trigamma(b)) / 3);
        double mode = Math.log(a / b);
        double[] sums = new double[2];
        side(a, b, mode, -step, f, sums);
        side(a, b, mode + step, step, f, sums);
        return sums[1] / sums[0];
    }

    private static void side(double a, double b, double start, double step, DoubleUnaryOperator f, double[] sums) {
        double top = logDensity(a, b, Math.log(a / b));
        double u = start;
        double height = logDensity(a, b, u) - top;
        while (height > -NEGLIGIBLE && (step < 0 ? u > -EDGE : u < EDGE)) {
            add(Math.exp(height), u, f, sums);
            u += step;
            height = logDensity(a, b, u) - top;
        }
        double rate = step < 0 ? -a * step : b * step;
        add(Math.exp(height) / -Math.expm1(-rate), u, f, sums);
    }

    private static void add(double weight, double u, DoubleUnaryOperator f, double[] sums) {
        sums[0] += weight;
        sums[1] += weight * f.applyAsDouble(1 / (1 + Math.exp(-u)));
    }

    /** a log sigma(u) + b log sigma(-u). */
    private static double logDensity(double a, double b, double u) {
        double tail = Math.log1p(Math.exp(-Math.abs(u)));
        return -a * (Math.max(-u, 0) + tail) - b * (Math.max(u, 0) + tail);
    }

    /** E|x - c| = c (2 F_{a,b}(c) - 1) + m (1 - 2 F_{a+1,b}(c)), F the distribution function of the Beta distribution. */
    double absoluteDeviation(double c) {
        if (point()) {
            return Math.abs(c - mean);
        }
        if (concentration == 0) {
            return mean * (1 - c) + (1 - mean) * c;
        }
        double a = concentration * mean;
        double b = concentration * (1 - mean);
        return c * (2 * Beta.regularizedBeta(c, a, b) - 1) + mean * (1 - 2 * Beta.regularizedBeta(c, a + 1, b));
    }
}
