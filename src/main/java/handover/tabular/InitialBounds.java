package handover.tabular;

import java.util.Arrays;

/**
 * Bounds on the value of any belief that follow from the model alone: from below what doing one act for ever earns, from above
 * the fast informed bound. Both sequences of vectors are bounds from their first iteration on, so that stopping early is safe.
 * Immutable, thread safe.
 *
 * <p>Source: Hauskrecht, "Value-function approximations for partially observable Markov decision processes" (2000),
 * on QMDP, the fast informed bound and blind policies.
 */
final class InitialBounds {
    private static final double CONVERGED = 1e-9;
    private static final int MOST_SWEEPS = 20_000;
    /** Elementary steps that the fast informed bound may take. */
    private static final double MOST_WORK = 1e9;

    private final Alphas lower;
    private final double[] qmdp;
    private final double[] fib;
    private final Alphas upper;

    /** Throws {@link IllegalArgumentException} if the discount is 1, where values need not be finite. */
    InitialBounds(TabularPomdp m) {
        if (m.discount() >= 1) {
            throw new IllegalArgumentException("this solver needs a discount below 1, got " + m.discount());
        }
        lower = blind(m);
        qmdp = qmdp(m);
        fib = fastInformed(m, qmdp);
        Alphas all = new Alphas(m.states().size());
        for (int a = 0; a < m.acts().size(); a++) {
            all.add(fib, a * m.states().size(), a);
        }
        upper = all.pruned();
    }

    /** The bound from above at each certain belief, as a new array. */
    double[] corners() {
        int n = upper.states();
        double[] corner = new double[n];
        Arrays.fill(corner, Double.NEGATIVE_INFINITY);
        for (int i = 0; i < fib.length; i++) {
            corner[i % n] = Math.max(corner[i % n], fib[i]);
        }
        return corner;
    }

    /** One vector for each act that may be the best to do for ever. */
    Alphas lower() {
        return lower;
    }

    /** By act and state: its value if the state is known from the next step on. */
    double[] qmdp() {
        return qmdp;
    }

    /** By act and state: the fast informed bound on the value of the act. */
    double[] fib() {
        return fib;
    }

    /** The vectors of {@link #fib} that are the largest somewhere. */
    Alphas upper() {
        return upper;
    }

    /** From the worst reward for ever upwards. */
    private static Alphas blind(TabularPomdp m) {
        int n = m.states().size();
        Alphas all = new Alphas(n);
        for (int a = 0; a < m.acts().size(); a++) {
            double least = Double.POSITIVE_INFINITY;
            for (int s = 0; s < n; s++) {
                least = Math.min(least, m.reward[a * n + s]);
            }
            double[] v = new double[n];
            Arrays.fill(v, least / (1 - m.discount()));
            double[] w = new double[n];
            double change = 1;
            for (int k = 0; k < MOST_SWEEPS && change > CONVERGED; k++) {
                change = 0;
                for (int s = 0; s < n; s++) {
                    w[s] = m.reward[a * n + s] + m.discount() * expected(m, a, s, v, 0);
                    change = Math.max(change, Math.abs(w[s] - v[s]));
                }
                System.arraycopy(w, 0, v, 0, n);
            }
            all.add(v, 0, a);
        }
        return all.pruned();
    }

    private static double expected(TabularPomdp m, int a, int s, double[] v, int from) {
        double e = 0;
        for (int k = m.row[a * m.states().size() + s]; k < m.row[a * m.states().size() + s + 1]; k++) {
            e += m.probability[k] * v[from + m.next[k]];
        }
        return e;
    }

    private static double[] qmdp(TabularPomdp m) {
        int n = m.states().size();
        double most = Double.NEGATIVE_INFINITY;
        for (double r : m.reward) {
            most = Math.max(most, r);
        }
        double[] v = new double[n];
        Arrays.fill(v, most / (1 - m.discount()));
        double[] q = new double[m.reward.length];
        double change = 1;
        for (int k = 0; k < MOST_SWEEPS && change > CONVERGED; k++) {
            change = 0;
            for (int s = 0; s < n; s++) {
                double best = Double.NEGATIVE_INFINITY;
                for (int a = 0; a < m.acts().size(); a++) {
                    q[a * n + s] = m.reward[a * n + s] + m.discount() * expected(m, a, s, v, 0);
                    best = Math.max(best, q[a * n + s]);
                }
                change = Math.max(change, Math.abs(best - v[s]));
                v[s] = best;
            }
        }
        return q;
    }

    private static double[] fastInformed(TabularPomdp m, double[] qmdp) {
        int n = m.states().size();
        int acts = m.acts().size();
        double work = (double) acts * m.observations().size() * m.probability.length;
        double[] v = qmdp.clone();
        double[] w = new double[v.length];
        double change = 1;
        for (int k = 0; k < MOST_SWEEPS && change > CONVERGED && k * work < MOST_WORK; k++) {
            change = 0;
            for (int a = 0; a < acts; a++) {
                for (int s = 0; s < n; s++) {
                    double sum = 0;
                    for (int o = 0; o < m.observations().size(); o++) {
                        sum += bestAfter(m, a, s, o, v);
                    }
                    w[a * n + s] = m.reward[a * n + s] + m.discount() * sum;
                    change = Math.max(change, Math.abs(w[a * n + s] - v[a * n + s]));
                }
            }
            System.arraycopy(w, 0, v, 0, w.length);
        }
        return v;
    }

    /** max_a' sum_s' T(s' | s, a) O(o | a, s') v(a', s'). */
    private static double bestAfter(TabularPomdp m, int a, int s, int o, double[] v) {
        int n = m.states().size();
        int from = m.row[a * n + s];
        int to = m.row[a * n + s + 1];
        int seen = (a * m.observations().size() + o) * n;
        if (to - from == 1) {
            double p = m.probability[from] * m.sensed[seen + m.next[from]];
            double best = Double.NEGATIVE_INFINITY;
            for (int other = m.next[from]; p > 0 && other < v.length; other += n) {
                best = Math.max(best, v[other]);
            }
            return p > 0 ? p * best : 0;
        }
        double best = Double.NEGATIVE_INFINITY;
        for (int other = 0; other < v.length; other += n) {
            double e = 0;
            for (int k = from; k < to; k++) {
                e += m.probability[k] * m.sensed[seen + m.next[k]] * v[other + m.next[k]];
            }
            best = Math.max(best, e);
        }
        return best;
    }
}
