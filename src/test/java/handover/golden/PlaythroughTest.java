package handover.golden;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.Speech;
import handover.io.DomainFiles;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Step;
import handover.solver.Deadline;
import handover.solver.Poss;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * One seeded episode of each shipped domain in full, compared with the one on file. A change of the model, the filter, the
 * planner or the random streams shows here; {@code scripts/golden} writes the files anew, and the difference is then
 * reviewed like code.
 */
class PlaythroughTest {
    private static final Path FILES = Path.of("src/test/resources/golden");
    private static final boolean WRITE = Boolean.getBoolean("golden.write");
    private static final long SEED = 2026;

    @TestFactory
    Stream<DynamicTest> isAsOnFile() throws IOException {
        try (Stream<Path> domains = Files.list(Path.of("domains"))) {
            List<String> names = domains.map(p -> p.getFileName().toString()).filter(n -> n.endsWith(".json"))
                    .map(n -> n.substring(0, n.length() - ".json".length())).sorted().toList();
            return names.stream().map(name -> DynamicTest.dynamicTest(name, () -> compare(name)));
        }
    }

    private static void compare(String name) throws IOException {
        Path file = FILES.resolve(name + ".txt");
        String now = playthrough(name);
        if (WRITE) {
            Files.createDirectories(FILES);
            Files.writeString(file, now);
        }
        assertTrue(Files.exists(file), file + " is missing: run scripts/golden");
        assertEquals(Files.readString(file), now, name + " plays another episode than before; see scripts/golden");
    }

    private static String playthrough(String name) {
        HandoverDomain domain = DomainFiles.load(name);
        EpisodeRunner runner = new EpisodeRunner(domain, domain, new Poss(2, 4, true), SEED, 30, () -> Deadline.NONE, () -> 0);
        Episode episode = runner.play(0);
        StringBuilder text = new StringBuilder("%s, %s, seed %d\nwanted: %s\n".formatted(name, episode.solver(), SEED, episode.wanted()));
        append(text, "start", episode.start());
        int k = 0;
        for (Step step : episode.steps()) {
            Observation o = step.observation();
            text.append(String.format(Locale.ROOT, "\n%d. %s\n   heard: %s\n   saw: %s\n   pick: %s\n   reward: %.6f\n", ++k, step.act(),
                    o.speech() == null ? "nothing" : heard(o.speech()), o.gesture() == null ? "nothing" : saw(o.gesture()),
                    o.signal().name().toLowerCase(Locale.ROOT), step.reward()));
            append(text, "  ", step.belief());
        }
        return text.append(String.format(Locale.ROOT, "\nreturn: %.6f\n", episode.measures().discountedReturn())).toString();
    }

    private static void append(StringBuilder text, String indent, HandoverBelief belief) {
        text.append(indent).append(" b: ").append(distribution(belief, belief.probabilities())).append('\n');
        text.append(indent).append(" h: ").append(distribution(belief, belief.human())).append('\n');
    }

    private static String distribution(HandoverBelief belief, double[] p) {
        return IntStream.range(0, p.length)
                .mapToObj(i -> String.format(Locale.ROOT, "%s %.6f", belief.scene().objects().get(i).name(), p[i]))
                .collect(Collectors.joining(", "));
    }

    private static String heard(Speech speech) {
        return speech.alternatives().stream().map(a -> '"' + a.utterance().text() + '"').collect(Collectors.joining(" or "));
    }

    private static String saw(Gesture g) {
        return String.format(Locale.ROOT, "(%.6f, %.6f, %.6f)", g.direction().x(), g.direction().y(), g.direction().z());
    }
}
