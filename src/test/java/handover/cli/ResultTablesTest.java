package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.simulation.Estimate;
import handover.simulation.Summary;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** The layout of the tables, with numbers that do not come from a run. */
class ResultTablesTest {

    @Test
    void oneRowASolver() {
        Summary random = new Summary("random", 500, of(0.248, 0.038), of(1, 0), of(39.04, 3.16), of(16.8, 1.44),
                of(-253.14, 21.4), of(4, 0.4), of(-0.0001, 0.0049), of(-0.4523, 0.0123), of(1.5, 0.251), 0.0123, 0.5);
        Summary once = new Summary("a.solver.of.Mine$WithALongName", 1, of(0, 0.5), of(0, 0), sure(4), sure(1), sure(49),
                sure(0), sure(-1), sure(0), sure(1.5), Double.NaN, Double.NaN);
        String text = summaries(random, once);
        assertEquals("""
                solver                  success %    seconds      steps        return\
                \s questions   log score        Brier      h to b  ms p50/p99
                random (floor)          24.8+-3.8  39.0+-3.2  16.8+-1.4  -253.1+-21.4\
                \s  4.0+-0.4  0.00+-0.00  -0.45+-0.01  1.50+-0.25    12.3/500
                a.solver.o..hALongName  0.0+-50.0     4.0+-?     1.0+-?       49.0+-?\
                \s    0.0+-?    -1.00+-?      0.00+-?     1.50+-?         -/-
                """, text);
    }

    @Test
    void wideNumbersFit() {
        Summary wide = new Summary("clairvoyantly", 500, of(0.978, 0.121), of(1, 0), of(163.25, 13.14), of(97.4, 10.56),
                of(-1253.14, 121.4), of(22.8, 1.44), of(-3.123, 0.123), of(-0.4523, 0.0123), of(1.5, 0.251), 0.0123, 0.5);
        String text = summaries(wide, wide);
        assertTrue(text.lines().allMatch(line -> line.length() <= 130), text);
        assertEquals(1, text.lines().map(String::length).distinct().count(), text);
    }

    private static String summaries(Summary floor, Summary other) {
        return ResultTables.summaries(List.of(new ResultTables.Row(floor, "floor"), new ResultTables.Row(other, "")));
    }

    @Test
    void columnsAreAligned() {
        TextTable table = new TextTable(8, List.of("name", "a", "bb"));
        table.add(List.of("x", "12.5", "1"));
        table.add(List.of("abcdefghijk", "1", "100"));
        assertEquals("""
                name         a   bb
                x         12.5    1
                abc..ijk     1  100
                """, table.text());
    }

    @Test
    void differencesAreSaidInWords() {
        assertEquals("""
                solver   return more    95% interval              than poss
                confirm         -1.4    -2.3 to -0.5                  worse
                good           +12.0  +10.0 to +14.0                 better
                similar          0.0    -1.0 to +1.1  no difference shown
                once            +3.0         unknown  no difference shown
                """.replaceAll(" +", " "), ResultTables.differences("poss", List.of(
                        new ResultTables.Difference("confirm", new Estimate(-1.4, -2.3, -0.5)),
                        new ResultTables.Difference("good", new Estimate(12, 10, 14)),
                        new ResultTables.Difference("similar", new Estimate(0.04, -1, 1.1)),
                        new ResultTables.Difference("once", sure(3)))).replaceAll(" +", " "));
    }

    @Test
    void theLanguageOfTheComputerDoesNotMatter() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            oneRowASolver();
            assertEquals("[##########..........] 5 of 10 episodes, 2 a second, about 3 s left", Progress.line("episodes", 5, 10, 2));
        } finally {
            Locale.setDefault(before);
        }
    }

    private static Estimate of(double value, double half) {
        return new Estimate(value, value - half, value + half);
    }

    private static Estimate sure(double value) {
        return new Estimate(value, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }
}
