package handover.solver;

import handover.belief.HandoverBelief;
import handover.math.Simplex;

/**
 * When a plan is out of date because the belief went on while it was made. Pure, thread safe.
 *
 * @param threshold total variation distance, in [0, 1], by which b or h may move before a plan is made anew
 */
public record Replan(double threshold) {
    /** A tenth of the probability mass has moved. */
    public static final Replan DEFAULT = new Replan(0.1);

    /** Throws {@link IllegalArgumentException} if the threshold is not in [0, 1]. */
    public Replan {
        if (!(threshold >= 0 && threshold <= 1)) {
            throw new IllegalArgumentException("expected a total variation distance in [0, 1], got " + threshold);
        }
    }

    /**
     * Whether what is planned for one belief should be planned anew for another: if the task is not the same (other acts may
     * be legal, or mean something else), or if b or h moved by more than the threshold.
     */
    public boolean due(HandoverBelief planned, HandoverBelief now) {
        if (planned == now) {
            return false;
        }
        return !planned.task().equals(now.task())
                || distance(planned.probabilities(), now.probabilities()) > threshold
                || distance(planned.human(), now.human()) > threshold;
    }

    private static double distance(double[] p, double[] q) {
        return Simplex.l1(p, q) / 2;
    }
}
