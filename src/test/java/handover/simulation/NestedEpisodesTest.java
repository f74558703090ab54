package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.PerceptionParameters;
import handover.io.DomainFiles;
import handover.solver.Deadline;
import handover.solver.Solvers;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Episodes with people who may misperceive acts. */
class NestedEpisodesTest {
    private static final DomainSpec BASE = DomainFiles.read("bowls-and-spoons");

    private static List<String> play(HandoverDomain planner, HandoverDomain people, String solver, int episode) {
        Episode e = new EpisodeRunner(planner, people, Solvers.parse(solver), 5, 30, () -> Deadline.NONE, () -> 0).play(episode);
        return e.steps().stream().map(s -> s.act() + " " + s.observation() + " " + s.reward()).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"poss:H=2,C=4", "confirm", "threshold:p=0.9", "random", "clairvoyant"})
    void withoutMisperceptionTheyAreThoseOfTheBase(String solver) {
        HandoverDomain base = DomainFiles.domain(BASE);
        HandoverDomain none = DomainFiles.domain(BASE.with(s -> {
            s.variant = "nested";
            s.perception = new PerceptionParameters(0, 0, 50);
        }));
        for (int k = 0; k < 20; k++) {
            assertEquals(play(base, base, solver, k), play(none, none, solver, k));
        }
    }

    /** The people of a file misperceive acts whether the robot knows it or not. */
    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-nested", "bowls-incremental", "bowls-communicated"})
    void peopleOfAFileMisperceive(String planner) {
        DomainSpec spec = DomainFiles.read(planner);
        HandoverDomain people = DomainFiles.domain(DomainFiles.readHuman(spec, Path.of("domains/humans/distracted.json")));
        assertEquals(0.2, people.spec().perception().misread());
        HandoverDomain robot = DomainFiles.domain(spec);
        HandoverDomain attentive = DomainFiles.domain(spec.with(s -> s.perception = PerceptionParameters.EXACT));
        assertNotEquals(plays(robot, attentive), plays(robot, people));
    }

    private static List<List<String>> plays(HandoverDomain robot, HandoverDomain people) {
        return IntStream.range(0, 10).mapToObj(k -> play(robot, people, "confirm", k)).toList();
    }
}
