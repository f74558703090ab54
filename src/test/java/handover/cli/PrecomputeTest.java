package handover.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.io.PointJournal;
import handover.io.PolicyFile;
import handover.io.PolicyRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same run gives the same bytes, however it comes about. */
class PrecomputeTest {
    private static final int BELIEFS = 400;

    @TempDir
    Path folder;

    @Test
    void threadsMakeNoDifference() throws IOException {
        byte[] one = bytes("a", "--threads", "1");
        assertArrayEquals(one, bytes("b", "--threads", "3"));
        assertFalse(Arrays.equals(one, bytes("c", "--seed", "2")), "another seed is another policy");
        assertEquals(BELIEFS, PolicyFile.read(folder.resolve("a")).table().size());
        try (var files = Files.list(folder)) {
            assertEquals(3, files.count(), "nothing else is left");
        }
    }

    /** Whatever was on the disk of the partial file when the process died, the result is the same. */
    @Test
    void anyBeginningOfThePartialFileIsGoneOnWith() throws IOException {
        byte[] expected = bytes("a");
        byte[] partial = partial();
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 25; k++) {
            byte[] torn = Arrays.copyOf(partial, k < 3 ? 100 * k : random.nextInt(partial.length + 1));
            resume(torn, expected, "torn at " + torn.length);
            if (torn.length > 1000) {
                torn[500 + random.nextInt(torn.length - 500)] ^= 64;
                resume(torn, expected, "damaged, " + torn.length + " bytes");
            }
        }
        resume(partial, expected, "complete");
    }

    private void resume(byte[] partial, byte[] expected, String what) throws IOException {
        Files.write(folder.resolve("r.partial"), partial);
        Files.write(folder.resolve("r.tmp"), new byte[] {1, 2, 3});
        assertArrayEquals(expected, bytes("r"), what);
        assertFalse(Files.exists(folder.resolve("r.partial")));
        Files.delete(folder.resolve("r"));
    }

    /** A whole journal: that of a run which was stopped just before its policy was written. */
    private byte[] partial() throws IOException {
        Files.createDirectory(folder.resolve("p.tmp"));
        Output o = precompute("p");
        assertEquals(Main.BAD_INPUT, o.code(), "a folder is in the way");
        byte[] partial = Files.readAllBytes(folder.resolve("p.partial"));
        Files.delete(folder.resolve("p.tmp"));
        return partial;
    }

    @Test
    void aFinishedRunIsLeftAloneAndAnyOtherFileTooButRefused() throws IOException {
        byte[] made = bytes("a");
        Files.write(folder.resolve("a.partial"), new byte[0]);
        assertTrue(precompute("a").out().contains("is finished already"), "also if it died before it cleaned up");
        assertFalse(Files.exists(folder.resolve("a.partial")));
        Output other = precompute("a", "--seed", "2");
        assertEquals(Main.BAD_INPUT, other.code());
        assertTrue(other.err().contains("a: is the policy of another run (seed 1, not 2) and will not be overwritten"), other.err());
        assertArrayEquals(made, Files.readAllBytes(folder.resolve("a")));
        Files.writeString(folder.resolve("mine"), "mine");
        assertTrue(precompute("mine").err().contains("mine: is not a policy file and will not be overwritten"));
        Files.write(folder.resolve("b.partial"), partial());
        Output running = precompute("b", "--teacher", "confirm");
        assertEquals(Main.BAD_INPUT, running.code());
        assertTrue(running.err().contains("is not the unfinished policy of this run (teacher \"poss:H=1,C=1\", not \"confirm\")"), running.err());
    }

    @Test
    void onlyOneAtATime() throws IOException {
        Files.write(folder.resolve("a.partial"), partial());
        try (PointJournal journal = PointJournal.open(folder.resolve("a.partial"), run(), unit -> { })) {
            assertTrue(journal.units() > 0);
            assertTrue(precompute("a").err().contains("a.partial: this file is being written"));
        }
    }

    private PolicyRun run() throws IOException {
        bytes("any");
        return PolicyFile.read(folder.resolve("any")).run();
    }

    @Test
    void theResultIsASolverForSimulateAndPlan() throws IOException {
        Path file = folder.resolve("a");
        bytes("a");
        Output o = Output.of("simulate", "--domain", "bowls-and-spoons", "--solver", "nearest:" + file, "--episodes", "20", "--out", "-");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(Output.of("plan", "--solver", "nearest:" + file + ",radius=inf").out().contains("best: "));
        Output wrong = Output.of("plan", "--domain", "table-line-6", "--solver", "nearest:" + file);
        assertEquals(Main.BAD_INPUT, wrong.code());
        assertTrue(wrong.err().contains("is a policy for the domain bowls-and-spoons ("), wrong.err());
    }

    @Test
    void theLearningCurveIsATableAndACsv() throws IOException {
        bytes("a");
        Path csv = folder.resolve("curve.csv");
        Output o = Output.of("analyze", "nearest", "--policy", folder.resolve("a").toString(), "--sizes", "50,400", "--episodes", "20",
                "--csv", csv.toString());
        assertEquals(Main.FINE, o.code(), o.err());
        List<String> lines = Files.readAllLines(csv);
        assertEquals(3, lines.size());
        assertTrue(lines.get(0).startsWith("beliefs,teacher_return,return,"));
        assertEquals(lines.get(0).split(",").length, lines.get(1).split(",").length);
        assertTrue(lines.get(1).startsWith("50,") && lines.get(2).startsWith("400,"));
        assertTrue(Output.of("analyze", "nearest", "--policy", folder.resolve("a").toString(), "--sizes", "500").err()
                .contains("--sizes: expected numbers from 1 to 400"));
    }

    @Test
    void progressSaysHowManyHowFastAndHowLong() {
        assertEquals("[#####...............] 25 of 100 beliefs, 5 a second, about 15 s left", Progress.line("beliefs", 25, 100, 5));
        assertEquals("[....................] 0 of 100 beliefs, 0 a second, about unknown time left", Progress.line("beliefs", 0, 100, 0));
    }

    private byte[] bytes(String name, String... more) throws IOException {
        Output o = precompute(name, more);
        assertEquals(Main.FINE, o.code(), o.err());
        return Files.readAllBytes(folder.resolve(name));
    }

    private Output precompute(String name, String... more) {
        List<String> args = new ArrayList<>(List.of("precompute", "bowls-and-spoons", "--out", folder.resolve(name).toString(),
                "--beliefs", String.valueOf(BELIEFS)));
        if (!List.of(more).contains("--teacher")) {
            args.addAll(List.of("--teacher", "poss:H=1,C=1"));
        }
        args.addAll(List.of(more));
        return Output.of(args.toArray(String[]::new));
    }
}
