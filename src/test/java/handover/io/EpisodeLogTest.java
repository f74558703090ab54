package handover.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.math.Vector3;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.solver.Confirm;
import handover.solver.Deadline;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is written is read back, to the last bit. */
class EpisodeLogTest {
    private static final DomainSpec SPEC = DomainFiles.read("bowls-and-spoons").with(s -> s.handovers = 2);
    private static final DomainSpec PEOPLE = SPEC.with(s -> s.tau = 0.9);
    private static final RunHeader HEADER = new RunHeader(SPEC, PEOPLE, -5, List.of("confirm"), 7, 100, 0, null);

    @TempDir
    Path folder;

    @Test
    void episodesComeBack() throws IOException {
        Path log = folder.resolve("a.jsonl");
        EpisodeRunner runner = new EpisodeRunner(new HandoverDomain(SPEC), new HandoverDomain(PEOPLE), new Confirm(), -5, 100,
                () -> Deadline.NONE, () -> 0);
        try (EpisodeLogWriter writer = EpisodeLogWriter.create(log, HEADER)) {
            for (int k = 0; k < 7; k++) {
                writer.write(runner.play(k));
            }
        }
        try (EpisodeLogReader reader = EpisodeLogReader.open(log)) {
            assertEquals(HEADER, reader.header());
            for (int k = 0; k < 7; k++) {
                assertSame(runner.play(k), reader.next());
            }
            assertNull(reader.next());
            assertEquals(Files.size(log), reader.end());
        }
    }

    private static void assertSame(Episode expected, LoggedEpisode got) {
        assertEquals(expected.measures(), got.measures());
        assertEquals(expected.wanted(), got.wanted());
        assertEquals(expected.index(), got.index());
        assertEquals(expected.steps().size(), got.steps().size());
        for (int k = 0; k < got.steps().size(); k++) {
            assertEquals(expected.steps().get(k).act(), got.steps().get(k).act());
            assertEquals(expected.steps().get(k).observation(), got.steps().get(k).observation());
            assertEquals(expected.steps().get(k).reward(), got.steps().get(k).reward());
            assertArrayEquals(expected.steps().get(k).belief().probabilities(), got.steps().get(k).belief());
            assertArrayEquals(expected.steps().get(k).belief().human(), got.steps().get(k).human());
        }
    }

    /** Making it unit length again would change every third one in its last digits. */
    @Test
    void directionsComeBackExactly() {
        Random random = new Random(3);
        Vector3 shoulder = new Vector3(0, 0, 1);
        for (int k = 0; k < 20_000; k++) {
            Vector3 d = new Gesture(shoulder, new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()))
                    .direction();
            assertEquals(d, new Gesture(shoulder, d).direction());
        }
    }

    @Test
    void theFirstLineSaysWhatTheFileIs() throws IOException {
        Path file = folder.resolve("a.jsonl");
        EpisodeLogWriter.create(file, HEADER).close();
        assertTrue(EpisodeLogReader.looksLikeLog(file));
        Files.writeString(file, "{\"form");
        assertTrue(EpisodeLogReader.looksLikeLog(file));
        assertTrue(EpisodeLogReader.withoutHeader(file));
        assertMessage("expected an episode log, got no complete line", file);
        Files.writeString(file, "");
        assertMessage("expected an episode log, got an empty file", file);
        Files.writeString(file, "[]\n");
        assertMessage("line 1: expected an object {...}, got []", file);
        assertMessage("is a directory, not a file", folder);
        assertMessage("there is no such file", folder.resolve("b"));
    }

    private static void assertMessage(String message, Path file) {
        assertEquals(file + ": " + message,
                assertThrows(EpisodeLogException.class, () -> EpisodeLogReader.open(file)).getMessage());
    }
}
