package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands solve and export. */
class SolveTest {
    private static final String TIGER = "src/test/resources/pomdp/tiger.POMDP";

    @Test
    void saysWhatASolverEarnsAndBetweenWhichBoundsTheValueLies() {
        Output o = Output.of("solve", TIGER, "--solver", "point-based:gap=0.0001", "--solver", "random", "--episodes", "50");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().startsWith(TIGER + ": 2 states, 3 acts, 2 observations, discount 0.95\n50 episodes of at most 180 acts, seed 1\n"),
                o.out());
        String row = o.lines().stream().filter(l -> l.startsWith("point-based")).findFirst().orElseThrow();
        assertTrue(row.contains("19.37") && row.endsWith("listen"), row);
    }

    @Test
    void theSameSeedEarnsTheSameOnAnyNumberOfThreads() {
        String[] one = {"solve", TIGER, "--solver", "qmdp", "--episodes", "40", "--threads", "1"};
        String[] four = {"solve", TIGER, "--solver", "qmdp", "--episodes", "40", "--threads", "4"};
        assertEquals(earned(Output.of(one)), earned(Output.of(four)));
    }

    /** Whoever stops the third solver, or sees it fail, has what the others earned. */
    @Test
    void eachRowIsPrintedWhenItIsKnown(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("far.POMDP"), Files.readString(Path.of(TIGER)).replaceAll("discount:.*", "discount: 1"));
        Output o = Output.of("solve", file.toString(), "--solver", "random", "--solver", "qmdp", "--episodes", "5", "--max-steps", "9");
        assertEquals(Main.BAD_INPUT, o.code());
        assertTrue(o.err().startsWith("handover: --solver: qmdp: this solver needs a discount below 1"), o.err());
        List<String> lines = o.lines();
        assertTrue(lines.get(lines.size() - 1).startsWith("random "), o.out());
        assertTrue(lines.get(lines.size() - 2).startsWith("solver "), o.out());
    }

    @Test
    void aTerminalShowsWhoIsSolvingAndNoRowIsWrittenOverIt() {
        ByteArrayOutputStream both = new ByteArrayOutputStream();
        PrintStream shown = new PrintStream(both, true, StandardCharsets.UTF_8);
        AtomicLong clock = new AtomicLong();
        Main.run(new String[] {"solve", TIGER, "--solver", "qmdp", "--solver", "random", "--episodes", "200", "--threads", "1"},
                new Console(InputStream.nullInputStream(), shown, shown, true, () -> clock.addAndGet(1_000_000)));
        String text = both.toString(StandardCharsets.UTF_8);
        assertTrue(text.indexOf("\rqmdp is solving the model") < text.indexOf("\rqmdp  "), text);
        assertTrue(text.indexOf("\rqmdp  ") < text.indexOf("\rrandom is solving the model"), text);
        List<String> rows = text.lines().filter(l -> l.matches("(solver|qmdp|random)  .*")).toList();
        assertEquals(3, rows.size(), text);
        assertEquals(1, rows.stream().mapToInt(String::length).distinct().count(), text);
    }

    private static String earned(Output o) {
        return o.lines().stream().filter(l -> l.startsWith("qmdp")).findFirst().orElseThrow().replaceAll("(\\S+ +\\S+ to \\S+).*", "$1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "table-line-6", "bowls-incremental"})
    void whatIsExportedCanBeSolved(String domain, @TempDir Path folder) throws Exception {
        Path file = folder.resolve("bowls.POMDP");
        Output written = Output.of("export", domain, "--keep", "wish", "--out", file.toString());
        assertEquals(Main.FINE, written.code(), written.err());
        assertTrue(Files.readString(file).startsWith("# The handover domain " + domain + " ("));
        Output solved = Output.of("solve", file.toString(), "--solver", "fib", "--episodes", "5");
        assertEquals(Main.FINE, solved.code(), solved.err());
        assertTrue(Files.size(file) < 3_000_000);
        assertTrue(Output.of("export", domain, "--keep", "wish").out().equals(Files.readString(file)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            solve nothing.POMDP | nothing.POMDP: there is no such file or folder
            solve src | src: is a directory, not a file
            solve pom.xml | pom.xml:1:1: expected discount, values, states, actions, observations, start, T, O or R, got "<?xml"
            solve | Missing required parameter: 'FILE'
            solve x --solver sarsop | solver "sarsop": expected one of anytime, point-based, exact, poss, qmdp, fib, random
            solve x --episodes 0 | --episodes: expected a whole number of at least 1, got 0
            solve x --solver qmdp --solver qmdp | --solver: expected each solver once, got qmdp twice
            export | Missing required parameter: 'DOMAIN'
            export nowhere | nowhere: there is no such file, and no shipped domain of this name
            export bowls-and-spoons --format json | --format: expected pomdp, got json
            export bowls-and-spoons --keep all | --keep: expected wish, reference or expectation, got all
            export kitchen-20 | kitchen-20: expected a model of at most 40000000 numbers
            """)
    void saysWhatIsWrong(String command, String message) {
        Output o = Output.of(command.split(" "));
        assertTrue(o.err().startsWith("handover: " + message), o.err());
        assertEquals(1, o.err().lines().count(), o.err());
        assertEquals(Main.BAD_INPUT, o.code());
    }
}
