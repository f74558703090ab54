package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.Observation;

/**
 * One step of an episode. Immutable.
 *
 * @param act what the robot did
 * @param observation what it sensed
 * @param reward what it earned
 * @param belief what it believed afterwards
 */
public record Step(Act act, Observation observation, double reward, HandoverBelief belief) {}
