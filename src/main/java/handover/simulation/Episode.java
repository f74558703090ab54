package handover.simulation;

import handover.belief.HandoverBelief;
import java.util.List;

/**
 * One simulated episode. Immutable.
 *
 * @param index in its run
 * @param solver that decided
 * @param wanted name of the object that the human wanted first
 * @param start what the robot believed before the first act
 * @param steps in order
 * @param measures what it was worth
 * @param decisionNanos how long each decision took, in nanoseconds; not part of what is reproducible
 */
public record Episode(int index, String solver, String wanted, HandoverBelief start, List<Step> steps, Measures measures,
        long[] decisionNanos) {}
