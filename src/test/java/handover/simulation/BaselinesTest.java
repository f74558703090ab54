package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.solver.Deadline;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Every baseline ends its episodes, with increments too, and is worth something between what the floor and the ceiling are. The
 * interval of a paired difference is of 95%; differences here are so large that it misses 0 by many of its widths (fixed seed).
 */
class BaselinesTest {
    private static final int EPISODES = 300;
    private static final List<String> BASELINES = List.of("qmdp", "heuristic", "greedy", "confirm", "threshold:p=0.9");

    private static List<Episode> play(HandoverDomain domain, String solver) {
        EpisodeRunner runner = new EpisodeRunner(domain, domain, Solvers.parse(solver), 5, EpisodeRunner.STEP_LIMIT,
                () -> Deadline.NONE, () -> 0);
        List<Episode> all = new ArrayList<>();
        for (int k = 0; k < EPISODES; k++) {
            all.add(runner.play(k));
        }
        return all;
    }

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-incremental", "bowls-communicated", "bowls-incremental-communicated",
        "table-line-6", "kitchen-20"})
    void betweenFloorAndCeiling(String name) {
        HandoverDomain domain = DomainFiles.load(name);
        List<Episode> ceiling = play(domain, "clairvoyant");
        List<Episode> floor = play(domain, "random");
        for (String baseline : BASELINES) {
            List<Episode> played = play(domain, baseline);
            assertTrue(Summary.returnDifference(ceiling, played).low() > 0, baseline + " and the ceiling");
            assertTrue(Summary.returnDifference(played, floor).low() > 0, baseline + " and the floor");
            assertTrue(Summary.of(played).handedOver().value() > 0.99, baseline + " hands over: " + Summary.of(played).handedOver());
        }
    }
}
