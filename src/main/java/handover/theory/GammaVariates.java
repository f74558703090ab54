package handover.theory;

import java.util.random.RandomGenerator;

/**
 * Draws from gamma and Dirichlet distributions. Source: Marsaglia and Tsang, "A simple method for generating gamma
 * variables", 2000.
 */
final class GammaVariates {
    private GammaVariates() {}

    /** A draw from Dir(alpha), alpha >= 0 (not modified), in logarithms, so that the smallest alpha cannot give 0/0. */
    static double[] dirichlet(double[] alpha, RandomGenerator random) {
        double[] x = new double[alpha.length];
        double max = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < x.length; j++) {
            x[j] = alpha[j] > 0 ? logGamma(alpha[j], random) : Double.NEGATIVE_INFINITY;
            max = Math.max(max, x[j]);
        }
        double sum = 0;
        for (int j = 0; j < x.length; j++) {
            x[j] = Math.exp(x[j] - max);
            sum += x[j];
        }
        for (int j = 0; j < x.length; j++) {
            x[j] /= sum;
        }
        return x;
    }

    /** The logarithm of a gamma variate of shape {@code a} > 0 and scale 1; below 1 by Gamma(a) = Gamma(a+1) U^(1/a). */
    static double logGamma(double a, RandomGenerator random) {
        if (a < 1) {
            return logGamma(a + 1, random) + Math.log(1 - random.nextDouble()) / a;
        }
        double d = a - 1.0 / 3;
        double c = 1 / Math.sqrt(9 * d);
        while (true) {
            double x = random.nextGaussian();
            double v = 1 + c * x;
            if (v > 0) {
                v = v * v * v;
                if (Math.log(1 - random.nextDouble()) < x * x / 2 + d - d * v + d * Math.log(v)) {
                    return Math.log(d * v);
                }
            }
        }
    }
}
