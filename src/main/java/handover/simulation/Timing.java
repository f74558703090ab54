package handover.simulation;

import handover.solver.Replan;

/**
 * What takes how long in a timed episode. Immutable.
 *
 * @param latency of planning
 * @param responses of the human
 * @param replan by how much the belief may move before a plan is out of date; for the concurrent agent
 * @param patience seconds after the end of an act in which the concurrent agent may still start to plan anew, at least 0 or
 *     infinite (people react once to an act, so that this ends); with 0 and a fixed latency it never pauses longer between two acts than
 *     the sequential one
 */
public record Timing(PlanningLatency latency, ResponseTimes responses, Replan replan, double patience) {
    /** Throws {@link IllegalArgumentException} for a patience below 0. */
    public Timing {
        if (!(patience >= 0)) {
            throw new IllegalArgumentException("expected a patience of at least 0 s, got " + patience);
        }
    }
}
