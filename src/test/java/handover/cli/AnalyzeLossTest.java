package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** {@code analyze loss}. */
class AnalyzeLossTest {
    private static double loss(String out, String solver) {
        Matcher m = Pattern.compile("(?m)^" + Pattern.quote(solver) + "\\s+(-?[0-9.]+) \\[").matcher(out);
        assertTrue(m.find(), out);
        return Double.parseDouble(m.group(1));
    }

    /** Which loses nothing by its own values; and an act at random loses much. */
    @Test
    void theReferenceLosesNothingByItsOwnValues() {
        Output run = Output.of("analyze", "loss", "--beliefs", "20", "--runs", "1", "--reference", "poss:H=1,C=1", "--solver", "poss:H=1,C=1",
                "--solver", "random", "--warm-up", "0");
        assertEquals(0, run.code(), run.err());
        assertEquals(0, loss(run.out(), "poss:H=1,C=1"), 0);
        assertTrue(loss(run.out(), "random") > 3, run.out());
    }

    /** The third column is the paired difference: with nothing lost by the first, the loss itself. And a limit is obeyed. */
    @Test
    void theFirstIsComparedWithTheOthers() {
        Output run = Output.of("analyze", "loss", "--beliefs", "10", "--runs", "1", "--reference", "poss:H=1,C=1", "--warm-up", "0",
                "--solver", "poss:H=1,C=1", "--solver", "random", "--solver", "poss:H=20,C=50@1");
        assertEquals(0, run.code(), run.err());
        assertTrue(Pattern.compile("(?m)^random\\s+(-?[0-9.]+ \\[.*?\\])\\s+\\1\\s").matcher(run.out()).find(), run.out());
        assertTrue(run.out().contains("poss:H=20,C=50@1 "), run.out());
    }

    @Test
    void whatCannotBeMeantIsSaid() {
        assertTrue(Output.of("analyze", "loss", "--warm-up", "-1").err().contains("--warm-up: expected seconds of at least 0, got -1"));
        assertTrue(Output.of("analyze", "loss", "--warm-up", "Infinity").err().contains("--warm-up: expected seconds of at least 0, got Inf"));
        assertTrue(Output.of("analyze", "loss", "--beliefs", "1").err().contains("--beliefs: expected a whole number of at least 2"));
        Output run = Output.of("analyze", "loss", "--beliefs", "2", "--reference", "confirm");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--reference: expected a solver that values every act, got confirm"), run.err());
    }
}
