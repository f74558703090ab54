package handover.tabular;

import handover.solver.Deadline;
import java.util.random.RandomGenerator;

/** What to do at a belief. A pure function of its arguments; thread safe. */
@FunctionalInterface
public interface TabularPolicy {
    /**
     * Decides, also if the deadline has passed already.
     *
     * @param belief over the states, not modified
     * @param deadline when to stop thinking
     * @param random all the chance that the decision may use
     */
    TabularDecision decide(double[] belief, Deadline deadline, RandomGenerator random);
}
