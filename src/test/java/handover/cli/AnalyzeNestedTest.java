package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The experiment on nested beliefs: the same but for times, and a clear word for what it cannot do. */
class AnalyzeNestedTest {
    private static Output run(String... more) {
        String[] small = {"analyze", "nested", "--dialogues", "3", "--particles", "50", "--episodes", "4", "--solver", "confirm"};
        String[] all = Arrays.copyOf(small, small.length + more.length);
        System.arraycopy(more, 0, all, small.length, more.length);
        return Output.of(all);
    }

    /** Without the last column where it is microseconds. */
    private static List<String> timeless(Output o) {
        assertEquals(Main.FINE, o.code(), o.err());
        List<String> lines = o.lines();
        int costs = lines.indexOf("What an act costs:");
        int worth = lines.stream().filter(l -> l.startsWith("What it is worth")).map(lines::indexOf).findFirst().orElseThrow();
        assertTrue(costs > 0 && worth > costs, o.out());
        return IntStream.range(0, lines.size())
                .mapToObj(i -> i > costs && i < worth ? lines.get(i).replaceAll("\\s+[\\d,]+$", "") : lines.get(i)).toList();
    }

    @Test
    void isRepeatable() {
        assertEquals(timeless(run("--people", "0.1/0.3")), timeless(run("--people", "0.1/0.3")));
    }

    @Test
    void playsWithThePeopleThatAreGiven() {
        Output o = run("--people", "0.1/0.3,1/0", "--objects", "2,3");
        assertEquals(Main.FINE, o.code(), o.err());
        List<String> rows = o.lines().subList(o.lines().size() - 2, o.lines().size());
        assertTrue(rows.get(0).startsWith("0.10       0.30  "), o.out());
        assertTrue(rows.get(1).startsWith("1.00       0.00  "), o.out());
        assertEquals(4, o.lines().stream().filter(l -> l.startsWith("counting ") || l.startsWith("particles again ")).count(), o.out());
    }

    @Test
    void saysWhatItCannotDo() {
        bad("--domain: in bowls-and-spoons every act is perceived as it is meant; expected perception.missed or perception.misread "
                + "above 0", "--domain", "bowls-and-spoons");
        bad("--people: expected two probabilities, such as 0.1/0.2, got \"0.5\"", "--people", "0.5");
        bad("--people: 0.5/0.6: misread: expected at most 1 - missed = 0.5, got 0.6", "--people", "0.5/0.6");
        bad("--objects: expected a whole number of at least 2, got 1", "--objects", "1");
        bad("--dialogues: expected a whole number of at least 1, got 0", "--dialogues", "0");
    }

    private static void bad(String message, String option, String value) {
        Output o = Output.of("analyze", "nested", option, value);
        assertEquals(Main.BAD_INPUT, o.code(), o.out());
        assertEquals("handover: " + message, o.err().strip());
    }
}
