package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.solver.Solvers;
import handover.tabular.TabularSolvers;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What cannot be meant is said in one line, with exit code 2; help and version are everywhere. */
class UsageTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            simulat | Unmatched argument at index 0: 'simulat'; did you mean simulate
            simulate --episodes x | --episodes: expected a whole number, got "x"
            simulate --episodes 1e3 | --episodes: expected a whole number, got "1e3"
            simulate --episodes 2.5 | --episodes: expected a whole number, got "2.5"
            simulate --episodes 99999999999 | --episodes: expected a whole number from -2147483648 to 2147483647, got 99999999999
            simulate --seed x | --seed: expected a whole number, got "x"
            simulate --seed 99999999999999999999 | --seed: expected a whole number from -9223372036854775808 to 9223372036854775807, got 99999999999999999999
            analyze nested --objects 3,four | --objects: expected a whole number, got "four"
            bridge --max-age 2s | --max-age: expected a number, got "2s"
            simulate --timed --replan much | --replan: expected a number, got "much"
            simulate --episodes 0 --out - | --episodes: expected a whole number of at least 1, got 0
            simulate --threads 0 --out - | --threads: expected a whole number of at least 1, got 0
            simulate --threads 1000000 --out - | --threads: expected a whole number of at most 1024, got 1000000
            analyze reward --objects 50 | --objects, --grid: expected at most 100000 beliefs in the grid, got more with 50 objects
            analyze reward --grid 2147483647 | --objects, --grid: expected at most 100000 beliefs in the grid, got more with 3 objects
            simulate --deadline-ms -1 --out - | --deadline-ms: expected a whole number of at least 0, got -1
            simulate --max-steps 0 --out - | --max-steps: expected a whole number of at least 1, got 0
            simulate --domain tabel --out - | tabel: there is no such file, and no shipped domain of this name
            simulate --human nobody.json --out - | nobody.json: there is no such file
            simulate --solver poss --solver poss:H=3 --out - | --solver: expected each solver once, got poss:H=3,C=10 twice
            simulate --solver mcts --out - | solver "mcts": expected one of poss, anytime, threshold, confirm, heuristic, greedy, qmdp, burlap, random, clairvoyant, nearest
            simulate --resume --out - | --resume: expected a log to resume, got --out -
            plan --solver clairvoyant | --solver: clairvoyant is told what the person wants, which nobody knows here
            plan --belief cup=1 | --belief: cup: expected the name of an object, one of metal_bowl, color_bowl
            plan --belief color_bowl=0.5 | --belief: expected probabilities that sum to 1, got a sum of 0.5
            plan --belief color_bowl=2 | --belief: color_bowl: expected a probability in [0, 1], got 2.0
            plan --belief color_bowl=NaN | --belief: color_bowl: expected a probability in [0, 1], got NaN
            plan --belief color_bowl=much | --belief: color_bowl: expected a probability in [0, 1], got "much"
            plan --belief color_bowl=1,metal_bowl | --belief: expected NAME=PROBABILITY,NAME=PROBABILITY, got "metal_bowl"
            plan --belief color_bowl=1,color_bowl=0 | --belief: color_bowl: expected each object once, got it twice
            plan --human-belief nothing.json | --human-belief: expected NAME=PROBABILITY,NAME=PROBABILITY or a JSON file, got "nothing.json"
            plan --foo | Unknown option: '--foo'
            check | Missing required parameter: 'FILE'
            replay nothing.jsonl | nothing.jsonl: there is no such file
            infer | Missing required parameter: 'DOMAIN'
            simulate extra | Unmatched argument at index 1: 'extra'
            """)
    void saysWhatIsWrong(String command, String message) {
        Output o = Output.of(command.split(" "));
        assertTrue(o.err().startsWith("handover: " + message), o.err());
        assertEquals(1, o.err().lines().count(), o.err());
        assertEquals("", o.out());
        assertEquals(Main.BAD_INPUT, o.code());
    }

    @Test
    void aCommandIsExpected() {
        Output o = Output.of("--debug");
        assertEquals(Main.BAD_INPUT, o.code());
        assertTrue(o.err().startsWith("handover: expected a command"), o.err());
        assertTrue(o.err().contains("\tat handover.cli.Main"), "--debug shows where");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "simulate ", "plan ", "check ", "replay ", "infer ", "bench "})
    void helpAndVersionAreEverywhere(String command) {
        Output help = Output.of((command + "--help").split(" "));
        assertEquals(Main.FINE, help.code());
        assertTrue(help.out().startsWith(("Usage: handover " + command).strip()), help.out());
        assertEquals(new Output(Main.FINE, "handover 0.1.0\n", ""), Output.of((command + "--version").split(" ")));
    }

    @Test
    void helpListsTheSolvers() {
        assertTrue(Output.of("plan", "--help").out().contains("  poss        looks H=3 acts ahead with C=10 samples"));
    }

    /** Each line begins with a name, or where the descriptions do. */
    @Test
    void descriptionsOfSolversAreIndented() {
        assertSolvers(Output.of("plan", "--help").out(), Solvers.names(), Solvers::description);
        assertSolvers(Output.of("solve", "--help").out(), TabularSolvers.names(), TabularSolvers::description);
    }

    private static void assertSolvers(String help, List<String> names, UnaryOperator<String> description) {
        String list = help.substring(help.indexOf("Solvers:\n") + "Solvers:\n".length());
        assertTrue(list.lines().count() > names.size(), "some description needs more than a line: " + list);
        assertTrue(list.lines().allMatch(l -> l.matches(" {2}[a-z-]+ +\\S.*| {14}\\S.*")), list);
        String unwrapped = list.replaceAll("\n {14}", " ");
        names.forEach(n -> assertTrue(unwrapped.contains(String.format("  %-12s%s\n", n, description.apply(n))), unwrapped));
    }
}
