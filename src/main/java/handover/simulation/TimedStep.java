package handover.simulation;

import java.util.List;

/**
 * When one act happened, and on what it was decided. Immutable.
 *
 * @param start seconds since the start of the episode
 * @param end when it was over
 * @param plannedAt when the planning that chose it started
 * @param plannedFor version of the belief that it was chosen for
 * @param version of the belief when it started
 * @param differs whether on the belief of its start something else would have been chosen
 * @param plannings that were started since the start of the act before
 * @param arrivals of what the human said and showed in reaction to it
 */
public record TimedStep(double start, double end, double plannedAt, long plannedFor, long version, boolean differs,
        int plannings, List<Arrival> arrivals) {
    public TimedStep {
        arrivals = List.copyOf(arrivals);
    }

    /** Whether something was known at its start that was not when it was planned. */
    public boolean stale() {
        return plannedFor < version;
    }
}
