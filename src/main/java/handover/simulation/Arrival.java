package handover.simulation;

import handover.belief.BeliefTracker;
import handover.domain.Gesture;
import handover.domain.Speech;

/**
 * Something that the simulated human said or showed; one of {@code speech} and {@code gesture} is null. Immutable.
 *
 * @param at when it was said or shown, seconds since the start of the episode: against the act of this time it is weighed
 * @param arrives when the robot's sensors report it, at or after {@code at}
 */
public record Arrival(double at, double arrives, Speech speech, Gesture gesture) {

    BeliefTracker correct(BeliefTracker belief) {
        return speech == null ? belief.saw(gesture) : belief.heard(speech);
    }
}
