package handover.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run is a function of its options: on any number of threads, and in as many pieces as it likes. */
class SimulateTest {
    private static final int EPISODES = 53;

    @TempDir
    Path folder;

    @Test
    void saysWhatItDidAndWhatTheNumbersMean() throws IOException {
        Path log = folder.resolve("a.jsonl");
        Output o = simulate(log);
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().contains("On the table (domain bowls-and-spoons): metal_bowl, color_bowl, plastic_spoon,"), o.out());
        assertTrue(o.out().contains("3 solvers play " + EPISODES + " episodes each"), o.out());
        assertTrue(o.out().contains("seed 1."), o.out());
        assertTrue(o.out().contains("People speak, point and answer as the robot believes"), o.out());
        assertTrue(o.out().contains("clairvoyant (ceiling)  100.0+-"), o.out());
        assertTrue(o.out().contains("than threshold:p=0.8"), o.out());
        assertTrue(o.out().contains("\nsuccess %   episodes whose first"), o.out());
        assertTrue(o.out().endsWith("Every step is in " + log + "; handover replay " + log + " checks its beliefs.\n"), o.out());
        assertTrue(o.lines().stream().limit(o.lines().size() - 1).allMatch(line -> line.length() <= 130), o.out());
        assertEquals(1 + 3 * EPISODES, Files.readAllLines(log).size());
    }

    @Test
    void threadsDoNotMatter() throws IOException {
        Path one = folder.resolve("1.jsonl");
        Path four = folder.resolve("4.jsonl");
        simulate(one, "--threads", "1");
        simulate(four, "--threads", "4");
        assertArrayEquals(Files.readAllBytes(one), Files.readAllBytes(four));
        simulate(four, "--seed", "2");
        assertFalse(Arrays.equals(Files.readAllBytes(one), Files.readAllBytes(four)), "another seed, other episodes");
    }

    @Test
    void aRunMayStopAnywhere() throws IOException {
        Path log = folder.resolve("whole.jsonl");
        String table = table(simulate(log));
        byte[] whole = Files.readAllBytes(log);
        Random random = new Random(7);
        int header = Files.readString(log).indexOf('\n');
        List<Integer> cuts = new ArrayList<>(List.of(0, 1, header, header + 1, whole.length - 1, whole.length));
        for (int k = 0; k < 8; k++) {
            cuts.add(random.nextInt(whole.length));
        }
        for (int cut : cuts) {
            Files.write(log, Arrays.copyOf(whole, cut));
            Output resumed = simulate(log, "--resume");
            assertEquals(Main.FINE, resumed.code(), resumed.err());
            assertArrayEquals(whole, Files.readAllBytes(log), "cut after " + cut + " bytes");
            assertEquals(table, table(resumed), "cut after " + cut + " bytes");
        }
        Files.delete(log);
        assertTrue(simulate(log, "--resume").err().startsWith("nothing to resume in " + log));
        assertArrayEquals(whole, Files.readAllBytes(log));
    }

    @Test
    void onlyTheSameRunIsResumed() throws IOException {
        Path log = folder.resolve("a.jsonl");
        simulate(log);
        byte[] before = Files.readAllBytes(log);
        for (String[] other : new String[][] {{"--seed", "2"}, {"--max-steps", "99"}, {"--domain", "table-line-6"},
                {"--deadline-ms", "5"}, {"--episodes", "54"}}) {
            Output o = simulate(log, other[0], other[1], "--resume");
            assertEquals(Main.BAD_INPUT, o.code());
            assertTrue(o.err().startsWith("handover: " + log + ": is the log of another run ("), o.err());
        }
        assertArrayEquals(before, Files.readAllBytes(log));
        List<String> lines = new ArrayList<>(Files.readAllLines(log));
        lines.remove(2);
        Files.write(log, lines);
        Output o = simulate(log, "--resume");
        assertEquals("handover: " + log + ": line 3: episode 2 of clairvoyant is not the one that comes next\n", o.err());
    }

    @Test
    void otherFilesAreNotOverwritten() throws IOException {
        Path precious = Files.writeString(folder.resolve("precious.json"), "{\"format\": \"mine\"}\n");
        for (Path file : List.of(precious, folder)) {
            Output o = simulate(file);
            assertEquals(Main.BAD_INPUT, o.code());
            assertEquals("handover: " + file + ": is not an episode log and will not be overwritten; choose another --out\n",
                    o.err());
        }
        assertEquals("{\"format\": \"mine\"}\n", Files.readString(precious));
        Path nowhere = folder.resolve("no/such/folder.jsonl");
        Output o = simulate(nowhere);
        assertEquals("handover: " + nowhere + ": there is no such file or folder\n", o.err());
        assertEquals(Main.BAD_INPUT, o.code());
    }

    /** What a solver needs is looked at before an old log is replaced. */
    @Test
    void aSolverThatCannotPlayCostsNoLog() throws IOException {
        Path log = folder.resolve("a.jsonl");
        simulate(log);
        byte[] before = Files.readAllBytes(log);
        Output o = Output.of("simulate", "--solver", "nearest:" + folder.resolve("nothing.policy"), "--out", log.toString());
        assertEquals(Main.BAD_INPUT, o.code());
        assertEquals("handover: " + folder.resolve("nothing.policy") + ": there is no such file\n", o.err());
        assertEquals("", o.out());
        assertArrayEquals(before, Files.readAllBytes(log));
    }

    @Test
    void peopleMayBeOther() throws IOException {
        Path people = Files.writeString(folder.resolve("people.json"), "{\"acts\": {\"wait\": {\"speech_rate\": 0.1}}}");
        Path log = folder.resolve("a.jsonl");
        Output o = simulate(log, "--human", people.toString());
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().contains("People are not as the robot believes, but as in " + people + "."), o.out());
        assertTrue(Files.readAllLines(log).get(0).contains("\"people\":{"));
        assertEquals(Main.FINE, Output.of("replay", log.toString()).code());
    }

    @Test
    void aSolverMayBeAClass() {
        Output o = Output.of("simulate", "--solver", "handover.solver.Confirm", "--episodes", "1", "--out", "-");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().contains("\nconfirm "), o.out());
        assertTrue(o.out().contains("+-?"), "one episode has no interval");
    }

    private static Output simulate(Path log, String... more) {
        List<String> args = new ArrayList<>(List.of("simulate", "--solver", "clairvoyant", "--solver", "threshold:p=0.8",
                "--solver", "confirm", "--out", log.toString()));
        if (!List.of(more).contains("--episodes")) {
            args.addAll(List.of("--episodes", Integer.toString(EPISODES)));
        }
        args.addAll(List.of(more));
        return Output.of(args.toArray(String[]::new));
    }

    /** The tables without the decision times, which a log does not have. */
    private static String table(Output o) {
        return o.out().replaceAll("(?m) +(ms p50/p99|[-.0-9]+/[-.0-9]+)$", "");
    }
}
