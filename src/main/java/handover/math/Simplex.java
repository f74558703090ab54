package handover.math;

import java.util.Arrays;
import java.util.random.RandomGenerator;

/**
 * Kernels on probability vectors of length n. Pure but for the array parameters marked <em>modified</em>; no allocation
 * unless an array is returned.
 */
public final class Simplex {
    private Simplex() {}

    /** The uniform distribution over {@code n} outcomes (empty for n = 0). */
    public static double[] uniform(int n) {
        double[] p = new double[n];
        Arrays.fill(p, 1.0 / n);
        return p;
    }

    /** The distribution that is certain of {@code i}. */
    public static double[] vertex(int n, int i) {
        double[] p = new double[n];
        p[i] = 1;
        return p;
    }

    /**
     * One step of T_stay: each outcome stays with probability {@code stay}, else moves to one of the others uniformly.
     *
     * @param p distribution (sums to one), not modified (may be the same array as {@code out})
     * @param out receives T p; modified
     */
    public static void propagate(double stay, double[] p, double[] out, int n) {
        if (stay == 1 || n == 1) {
            if (p != out) {
                System.arraycopy(p, 0, out, 0, n);
            }
            return;
        }
        double move = (1 - stay) / (n - 1);
        for (int i = 0; i < n; i++) {
            out[i] = moved(stay, move, p[i]);
        }
    }

    /**
     * One step of T_stay and then Bayes' rule: out proportional to likelihood * (T p), or T p if that is 0 everywhere.
     *
     * @param p distribution (sums to one), not modified
     * @param likelihood not modified
     * @param out another array than {@code p}; modified
     */
    public static void update(double stay, double[] p, double[] likelihood, double[] out, int n) {
        double move = n == 1 ? 0 : (1 - stay) / (n - 1);
        double z = 0;
        for (int i = 0; i < n; i++) {
            double v = likelihood[i] * (n == 1 ? p[i] : moved(stay, move, p[i]));
            out[i] = v;
            z += v;
        }
        if (z > 0) {
            for (int i = 0; i < n; i++) {
                out[i] /= z;
            }
        } else {
            propagate(stay, p, out, n);
        }
    }

    /** What has probability {@code p} after one step in which everything else may become it. */
    private static double moved(double stay, double move, double p) {
        return stay * p + move * (1 - p);
    }

    /** Sum of the first {@code n} entries. */
    public static double sum(double[] p, int n) {
        double s = 0;
        for (int i = 0; i < n; i++) {
            s += p[i];
        }
        return s;
    }

    /**
     * Scales {@code p} (modified) to sum to one.
     *
     * @return the sum that it had; if that is 0 or not finite, {@code p} is left as it is
     */
    public static double normalise(double[] p, int n) {
        double s = sum(p, n);
        if (s > 0 && s < Double.POSITIVE_INFINITY) {
            for (int i = 0; i < n; i++) {
                p[i] /= s;
            }
        }
        return s;
    }

    /**
     * Shifts log weights (modified) so that their exponentials sum to one, without underflow.
     *
     * @return false, with {@code logWeights} unchanged, if every weight is zero (-infinity)
     */
    public static boolean normaliseLog(double[] logWeights) {
        double total = logSumExp(logWeights);
        if (total == Double.NEGATIVE_INFINITY) {
            return false;
        }
        for (int i = 0; i < logWeights.length; i++) {
            logWeights[i] -= total;
        }
        return true;
    }

    /** log sum_i exp(x_i); -infinity for an empty array. */
    public static double logSumExp(double[] x) {
        double max = Double.NEGATIVE_INFINITY;
        for (double v : x) {
            max = Math.max(max, v);
        }
        if (max == Double.NEGATIVE_INFINITY) {
            return max;
        }
        double s = 0;
        for (double v : x) {
            s += Math.exp(v - max);
        }
        return max + Math.log(s);
    }

    /** The first index with the largest entry; -1 for n = 0. */
    public static int argmax(double[] p, int n) {
        int best = n == 0 ? -1 : 0;
        for (int i = 1; i < n; i++) {
            if (p[i] > p[best]) {
                best = i;
            }
        }
        return best;
    }

    /** An index drawn from the distribution {@code p}; never one with p = 0. */
    public static int sample(double[] p, int n, RandomGenerator random) {
        return quantile(p, n, random.nextDouble());
    }

    /** The index at {@code level} (in [0, 1)) of the cumulative sums of the distribution {@code p}; never one with p = 0. */
    public static int quantile(double[] p, int n, double level) {
        double u = level;
        int last = -1;
        for (int i = 0; i < n; i++) {
            if (p[i] > 0) {
                last = i;
                u -= p[i];
                if (u < 0) {
                    return i;
                }
            }
        }
        return last;
    }

    /** sum_i |p_i - q_i|, in [0, 2] for distributions. */
    public static double l1(double[] p, double[] q) {
        double s = 0;
        for (int i = 0; i < p.length; i++) {
            s += Math.abs(p[i] - q[i]);
        }
        return s;
    }
}
