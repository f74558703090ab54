package handover.io;

import handover.domain.Act;
import handover.domain.Observation;
import handover.simulation.Measures;
import java.util.List;

/**
 * One episode as a log has it. Immutable; arrays must not be modified.
 *
 * @param index in its run
 * @param solver that decided
 * @param wanted name of the object that the human wanted first
 * @param steps in order
 * @param measures what it was worth
 */
public record LoggedEpisode(int index, String solver, String wanted, List<Step> steps, Measures measures) {

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
