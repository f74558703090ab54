package handover.belief;

import handover.domain.ActEffect;
import handover.domain.Task;
import java.util.Arrays;

/**
 * A state of mind that the human may be in: what they believe and what they think is open, with its probability for each
 * object that may be wanted. Where acts are perceived exactly there is one. Immutable, thread safe; arrays must not be
 * modified.
 *
 * @param task as the human sees it
 * @param step what they perceive of the act under way; null on an empty table
 * @param human beta, what they believe that the robot will hand over, one entry per object
 * @param log log p(wanted = i, this mind), one entry per object; over all minds of a belief the probabilities sum to one
 */
public record Mind(Task task, ActEffect step, double[] human, double[] log) {

    /** p(this mind), up to the normalisation over all minds. */
    public double weight() {
        double w = 0;
        for (double l : log) {
            w += Math.exp(l);
        }
        return w;
    }

    /** The same with other probabilities. */
    Mind weighing(double[] other) {
        return new Mind(task, step, human, other);
    }

    /** The same who sees the task otherwise. */
    Mind seeing(Task other) {
        return new Mind(other, step, human, log);
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Mind m && task.equals(m.task) && Arrays.equals(human, m.human) && Arrays.equals(log, m.log);
    }

    @Override
    public int hashCode() {
        return 31 * (31 * task.hashCode() + Arrays.hashCode(log)) + Arrays.hashCode(human);
    }
}
