package handover.io;

import handover.domain.Act;
import handover.domain.Observation;
import handover.simulation.Measures;
import handover.simulation.TimedStep;
import java.util.List;

/**
 * One episode as a log has it. Immutable; arrays must not be modified.
 *
 * @param index in its run
 * @param solver that decided
 * @param agent how its time was spent; null if the run is not timed
 * @param wanted name of the object that the human wanted first
 * @param steps in order
 * @param times one for each step; empty if the run is not timed
 * @param measures what it was worth
 */
public record LoggedEpisode(int index, String solver, String agent, String wanted, List<Step> steps, List<TimedStep> times,
        Measures measures) {

    /**
     * One step.
     *
     * @param act what the robot did
     * @param observation what it sensed
     * @param reward what it earned
     * @param onTable names of the objects that were left afterwards
     * @param belief b afterwards, one entry for each of them
     * @param human h afterwards, likewise
     */
    public record Step(Act act, Observation observation, double reward, List<String> onTable, double[] belief,
            double[] human) {}
}
