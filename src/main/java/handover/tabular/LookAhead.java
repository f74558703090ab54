package handover.tabular;

import handover.solver.Deadline;
import java.util.Arrays;

/**
 * Exact values of acts over a fixed number of acts, with nothing after them: all observations are weighed, equal beliefs only once.
 * What an act predicts is shared by its observations; the last act needs none. Used by one thread; what it allocates it uses again.
 */
final class LookAhead {
    private static final int CHECK = 64;

    private final TabularPomdp m;
    private final BeliefStore beliefs;
    /** By acts still to come: the value of each belief, NaN if not known yet. */
    private double[][] known = new double[0][];
    /** By acts still to come. */
    private double[][] predicted = new double[0][];
    private double[][] posterior = new double[0][];
    private Deadline deadline = Deadline.NONE;
    private int untilCheck;
    private boolean late;

    LookAhead(TabularPomdp m) {
        this.m = m;
        this.beliefs = new BeliefStore(m.states().size());
    }

    /**
     * Values of all acts.
     *
     * @param belief not modified
     * @param horizon acts to look ahead, at least 1
     * @param q receives the values; modified
     * @return false if the deadline passed first: then {@code q} is undefined
     */
    boolean values(double[] belief, int horizon, Deadline until, double[] q) {
        beliefs.clear();
        deadline = until;
        untilCheck = CHECK;
        late = false;
        while (known.length <= horizon) {
            int h = known.length;
            known = Arrays.copyOf(known, h + 1);
            predicted = Arrays.copyOf(predicted, h + 1);
            posterior = Arrays.copyOf(posterior, h + 1);
            known[h] = new double[1024];
            predicted[h] = new double[m.states().size()];
            posterior[h] = new double[m.states().size()];
        }
        for (double[] values : known) {
            Arrays.fill(values, Double.NaN);
        }
        int root = beliefs.number(belief);
        for (int a = 0; a < q.length; a++) {
            q[a] = actValue(root, a, horizon);
        }
        return !late;
    }

    /** Different beliefs that were met. */
    int nodes() {
        return beliefs.size();
    }

    private double value(int k, int horizon) {
        if (k >= known[horizon].length) {
            int before = known[horizon].length;
            known[horizon] = Arrays.copyOf(known[horizon], Math.max(k + 1, 2 * before));
            Arrays.fill(known[horizon], before, known[horizon].length, Double.NaN);
        }
        if (Double.isNaN(known[horizon][k])) {
            double best = Double.NEGATIVE_INFINITY;
            for (int a = 0; a < m.acts().size() && !late; a++) {
                best = Math.max(best, actValue(k, a, horizon));
            }
            known[horizon][k] = best;
        }
        return known[horizon][k];
    }

    private double actValue(int k, int a, int horizon) {
        int n = m.states().size();
        double reward = beliefs.dot(k, m.reward, a * n);
        if (horizon == 1 || late) {
            return reward;
        }
        if (--untilCheck == 0) {
            untilCheck = CHECK;
            late = deadline.passed();
        }
        double[] next = predicted[horizon];
        double[] after = posterior[horizon];
        beliefs.predict(k, m, a, next);
        double future = 0;
        for (int o = 0; o < m.observations().size(); o++) {
            double p = m.correct(next, a, o, after);
            if (p > 0) {
                future += p * value(beliefs.number(after), horizon - 1);
            }
        }
        return reward + m.discount() * future;
    }
}
