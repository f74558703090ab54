package handover.solver;

import handover.belief.HandoverBelief;
import java.util.random.RandomGenerator;

/** What to do at a belief. A pure function of its arguments; thread safe. */
@FunctionalInterface
public interface Policy {
    /**
     * Decides; with a legal act whatever happens, also if the deadline has passed already.
     *
     * @param belief whose task is not done
     * @param deadline when to stop thinking
     * @param random all the chance that the decision may use
     */
    Decision decide(HandoverBelief belief, Deadline deadline, RandomGenerator random);
}
