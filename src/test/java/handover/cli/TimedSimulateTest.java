package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code simulate --timed}: the same on any number of threads, and clear about what it does not do. */
class TimedSimulateTest {
    @TempDir
    Path folder;

    private static Output timed(String... more) {
        List<String> args = new ArrayList<>(List.of("simulate", "--timed", "--episodes", "30", "--solver", "poss:H=1,C=5", "--solver", "confirm"));
        args.addAll(List.of(more));
        return Output.of(args.toArray(String[]::new));
    }

    @Test
    void threadsDoNotMatter() {
        for (String latency : List.of("2s", "lognormal:median=1s,sigma=0.5", "nodes:5000/s")) {
            Output one = timed("--planning-latency", latency, "--threads", "1");
            assertEquals(Main.FINE, one.code(), one.err());
            assertEquals(one.out(), timed("--planning-latency", latency, "--threads", "4").out());
            assertFalse(one.out().equals(timed("--planning-latency", latency, "--seed", "2").out()), "another seed, other episodes");
        }
    }

    @Test
    void saysWhatConcurrencyIsWorth() {
        Output o = timed("--domain", "bowls-incremental");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().contains("Thinking takes 2s a decision; people react after lognormal:median=0.5s,sigma=0.4.\n"), o.out());
        assertTrue(o.out().contains("\nconfirm       sequential"), o.out());
        assertTrue(o.out().contains("\nconfirm       concurrent"), o.out());
        assertTrue(o.out().contains("concurrent less sequential"), o.out());
        assertTrue(o.out().contains("seconds to cancel"), o.out());
        assertTrue(o.lines().stream().allMatch(line -> line.length() <= 135), o.out());
        Output one = timed("--agent", "sequential");
        assertFalse(one.out().contains("concurrent"), one.out());
        assertFalse(one.out().contains("cancel"), "a pick of one increment cannot be called off: " + one.out());
    }

    /** The row of the untimed table is found again in the timed one. */
    @Test
    void withoutDelaysTheTableIsTheUntimedOne() {
        Output o = timed("--planning-latency", "0s", "--reaction", "none");
        Output untimed = Output.of("simulate", "--episodes", "30", "--solver", "poss:H=1,C=5", "--solver", "confirm", "--out", "-");
        for (String solver : List.of("poss:H=1,C=5", "confirm")) {
            List<String> row = row(untimed, solver);
            List<String> timed = row(o, solver);
            assertEquals(row.get(4), timed.get(6), "return of " + solver);
            assertEquals(row.get(1).split("\\+-")[0], timed.get(2), "success of " + solver);
        }
    }

    private static List<String> row(Output o, String solver) {
        return List.of(o.lines().stream().filter(line -> line.startsWith(solver)).findFirst().orElseThrow().split(" +"));
    }

    /** The log has times, and its beliefs follow from them bit for bit, for both agents and with people who are slow or late. */
    @ParameterizedTest
    @CsvSource({"bowls-and-spoons,none", "bowls-incremental,lognormal:median=2.5s;sigma=0.8", "bowls-communicated,3s"})
    void whatWasLoggedAgrees(String domain, String model) throws IOException {
        Path log = folder.resolve("a.jsonl");
        String reaction = model.replace(';', ',');
        Output o = timed("--out", log.toString(), "--domain", domain, "--reaction", reaction);
        assertEquals(Main.FINE, o.code(), o.err());
        assertEquals(timed("--out", "-", "--domain", domain, "--reaction", reaction).out()
                + "\nEvery step is in " + log + "; handover replay " + log + " checks its beliefs.\n", o.out());
        Output replay = Output.of("replay", log.toString());
        assertEquals("", replay.err());
        assertTrue(replay.out().matches("120 episodes with \\d+ steps agree\n"), replay.out());
        List<String> lines = Files.readAllLines(log);
        assertEquals(60, lines.stream().filter(line -> line.endsWith(",\"agent\":\"concurrent\"}")).count());
        assertEquals(60, lines.stream().filter(line -> line.endsWith(",\"agent\":\"sequential\"}")).count());
    }

    /** What was said and never arrived cannot have changed the belief. */
    @Test
    void aChangedTimeIsFound() throws IOException {
        Path log = folder.resolve("a.jsonl");
        timed("--out", log.toString(), "--agent", "sequential");
        Files.writeString(log, Files.readString(log).replaceFirst("\"speech_arrives\":[.0-9]+", "\"speech_arrives\":1e6"));
        Output o = Output.of("replay", log.toString());
        assertEquals(Main.DIFFERENT, o.code());
        assertTrue(o.err().matches("handover: \\S+a.jsonl: episode \\d+ of poss:H=1,C=5, sequential: step \\d+: belief of .*\n"), o.err());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            "start":2.0 | "start":-1      | line 2: steps[0].time.start: expected a time of at least 0.0 s, got -1
            "end":      | "end":1,"was": | line 2: steps[0].time.end: expected a time of at least 2.0 s, got 1
            "speech_at" | "speech"        | line 2: steps[0].time.speech_at: this field is missing
            "time":{    | "tame":{        | line 2: steps[0].time: this field is missing
            "agent":    | "agemt":        | line 2: agent: this field is missing
            "patience": | "patient":      | line 1: timed.patience: this field is missing
            """)
    void whatIsNoTimeIsSaidWithItsLine(String old, String changed, String message) throws IOException {
        Path log = folder.resolve("a.jsonl");
        timed("--out", log.toString());
        Files.writeString(log, Files.readString(log).replaceFirst(Pattern.quote(old), changed.replace("{", "\\{")));
        Output o = Output.of("replay", log.toString());
        assertEquals("handover: " + log + ": " + message + "\n", o.err());
        assertEquals(Main.BAD_INPUT, o.code());
    }

    @Test
    void aLogIsOnlyWrittenWhereItWasAskedFor() throws IOException {
        Path other = Files.writeString(folder.resolve("notes.txt"), "mine");
        Output o = timed("--out", other.toString());
        assertEquals("handover: " + other + ": is not an episode log and will not be overwritten; choose another --out\n", o.err());
        assertEquals("mine", Files.readString(other));
        assertFalse(timed("--agent", "concurrent").out().contains("Every step"));
        Path log = folder.resolve("a.jsonl");
        timed("--out", log.toString(), "--agent", "sequential");
        Output resumed = Output.of("simulate", "--resume", "--episodes", "30", "--solver", "poss:H=1,C=5", "--solver", "confirm",
                "--out", log.toString());
        assertEquals("handover: " + log + ": is the log of another run (timed), which cannot be resumed with these options\n",
                resumed.err());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --planning-latency 2         | --planning-latency: expected a time such as 2s or 10ms, lognormal:median=2s,sigma=0.3, or nodes:200000/s, got "2"
            --planning-latency measured  | --planning-latency: expected a time such as 2s or 10ms, lognormal:median=2s,sigma=0.3, or nodes:200000/s, got "measured"
            --reaction nodes:5/s         | --reaction: expected a time such as 2s or 10ms, lognormal:median=2s,sigma=0.3, or none, got "nodes:5/s"
            --reaction 4000s             | --reaction: expected 0 to 3600.0 s, got 4000.0
            --agent parallel             | --agent: expected sequential, concurrent or both, got parallel
            --replan 1.5                 | --replan: expected a total variation distance in [0, 1], got 1.5
            --patience soon              | --patience: expected a time such as 2s or 10ms, or unlimited, got "soon"
            --patience lognormal:median=2s,sigma=0.3 | --patience: expected a time such as 2s or 10ms, or unlimited, got "lognormal:median=2s,sigma=0.3"
            --deadline-ms 5              | --deadline-ms: expected no --timed with it
            --resume                     | --resume: expected no --timed with it
            """)
    void refusesWhatCannotBe(String options, String problem) {
        Output o = timed(options.split(" "));
        assertEquals(Main.BAD_INPUT, o.code());
        assertEquals("handover: " + problem + "\n", o.err());
        assertEquals("", o.out());
    }

    @ParameterizedTest
    @CsvSource({"--planning-latency,2s", "--agent,both", "--reaction,none", "--replan,0.1", "--patience,1s"})
    void timeIsOnlyForTheTimed(String option, String value) {
        Output o = Output.of("simulate", "--episodes", "1", "--out", "-", option, value);
        assertEquals(Main.BAD_INPUT, o.code());
        assertEquals("handover: " + option + ": expected --timed with it\n", o.err());
    }
}
