package handover.belief;

import handover.math.Simplex;
import java.util.Arrays;

/** Distributions as logarithms and back. Pure; arrays that are returned are new. */
final class LogWeights {
    private LogWeights() {}

    /** Log weights that are normalised up to rounding as a distribution. */
    static double[] exp(double[] log) {
        double[] p = new double[log.length];
        for (int i = 0; i < p.length; i++) {
            p[i] = Math.exp(log[i]);
        }
        Simplex.normalise(p, p.length);
        return p;
    }

    /** The distribution that log weights of any total are proportional to. */
    static double[] given(double[] log) {
        double[] shifted = log.clone();
        Simplex.normaliseLog(shifted);
        return exp(shifted);
    }

    static double[] log(double[] p) {
        double[] log = new double[p.length];
        for (int i = 0; i < p.length; i++) {
            log[i] = Math.log(p[i]);
        }
        return log;
    }

    /** Uniform over all but {@code x}; over {@code x} if there is nothing else. */
    static double[] excluding(int x, int n) {
        double[] p = Simplex.uniform(n);
        if (n > 1) {
            p[x] = 0;
            Simplex.normalise(p, n);
        }
        return p;
    }

    /** The entries but the one at {@code x}. */
    static double[] dropped(double[] p, int x) {
        double[] rest = new double[p.length - 1];
        System.arraycopy(p, 0, rest, 0, x);
        System.arraycopy(p, x + 1, rest, x, rest.length - x);
        return rest;
    }

    /**
     * A distribution over other outcomes: those that were there before share what is left as they did, new ones get 1 / n each.
     *
     * @param before for each outcome where it was, -1 if it is new
     */
    static double[] carried(double[] log, int[] before) {
        double[] kept = Arrays.stream(before).filter(k -> k >= 0).mapToDouble(k -> log[k]).toArray();
        if (!Simplex.normaliseLog(kept)) {
            Arrays.fill(kept, -Math.log(kept.length));
        }
        double share = Math.log((double) kept.length / before.length);
        double[] all = new double[before.length];
        int next = 0;
        for (int i = 0; i < all.length; i++) {
            all[i] = before[i] >= 0 ? kept[next++] + share : -Math.log(all.length);
        }
        return all;
    }
}
