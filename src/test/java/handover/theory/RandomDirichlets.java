package handover.theory;

import java.util.Arrays;
import java.util.random.RandomGenerator;

/** Hard inputs: alpha log-uniform from 0.05 to 500, likelihoods log-uniform from 1e-12 to 1 with exact zeros. */
final class RandomDirichlets {
    private RandomDirichlets() {}

    static double[] alpha(int n, RandomGenerator random) {
        double[] a = new double[n];
        for (int j = 0; j < n; j++) {
            a[j] = 0.05 * Math.pow(1e4, random.nextDouble());
        }
        return a;
    }

    /** At least one is not zero. */
    static double[] likelihood(int n, RandomGenerator random) {
        double[] l = new double[n];
        for (int j = 0; j < n; j++) {
            l[j] = random.nextInt(8) == 0 ? 0 : Math.pow(1e-12, random.nextDouble());
        }
        l[random.nextInt(n)] = Math.pow(1e-12, random.nextDouble());
        return l;
    }

    /** A distribution drawn from Dir(1, ..., 1). */
    static double[] belief(int n, RandomGenerator random) {
        double[] ones = new double[n];
        Arrays.fill(ones, 1);
        return GammaVariates.dirichlet(ones, random);
    }
}
