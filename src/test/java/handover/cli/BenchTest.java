package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import handover.domain.HandoverDomain;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The measurements of all parts arrive in the file and in the tables. */
class BenchTest {
    @TempDir
    Path folder;

    /** What the last command printed. */
    private String shown;

    private JsonNode bench(int code, String... more) throws IOException {
        Path file = folder.resolve("new/bench.json");
        List<String> command = new ArrayList<>(List.of("bench", "--out", file.toString()));
        command.addAll(List.of(more));
        if (!command.contains("--seconds")) {
            command.addAll(List.of("--seconds", "0.02", "--decisions", "6"));
        }
        Output o = Output.of(command.toArray(String[]::new));
        assertEquals(code, o.code(), o.err());
        shown = o.out();
        try (var files = Files.list(file.getParent())) {
            assertEquals(List.of(file), files.toList(), "no draft is left");
        }
        return new ObjectMapper().readTree(file.toFile());
    }

    @Test
    void aHeadSaysWhatWasMeasuredOn() throws IOException {
        JsonNode all = bench(0, "--parts", "allocation", "--commit", "abc");
        assertEquals("handover-bench", all.get("format").asText());
        assertEquals("abc", all.get("commit").asText());
        assertTrue(all.get("date").asText().matches("20\\d\\d-\\d\\d-\\d\\dT.*Z"));
        assertTrue(all.at("/machine/cores").asInt() > 0);
        assertTrue(all.at("/machine/java").asText().contains(System.getProperty("java.runtime.version")));
    }

    @Test
    void times() throws IOException {
        JsonNode rows = bench(0, "--parts", "time", "--objects", "3,4", "--variants", "base,incremental_communicated", "--time-solver",
                "poss:H=9,C=9@1/2", "--time-solver", "confirm").at("/parts/time");
        assertEquals(2 * 2 * 3, rows.size());
        for (JsonNode row : rows) {
            assertTrue(row.get("decisions").asInt() >= 3);
            assertTrue(row.get("median_ms").asDouble() > 0);
            assertTrue(row.get("median_ms").asDouble() <= row.get("p90_ms").asDouble());
            assertTrue(row.get("p90_ms").asDouble() <= row.get("max_ms").asDouble());
            assertTrue(row.get("median_cpu_ms").asDouble() <= row.get("median_ms").asDouble());
            assertEquals(row.get("limit_ms").isNull(), row.get("late_ms") == null && row.get("p99_late_ms") == null);
        }
        assertEquals("incremental_communicated", rows.get(11).get("variant").asText());
        assertEquals(4, rows.get(11).get("objects").asInt());
        assertEquals("confirm", rows.get(11).get("solver").asText());
        assertEquals(1, rows.get(0).get("limit_ms").asInt());
        assertTrue(shown.contains("\n| base "), shown);
        assertTrue(shown.contains("| poss:H=9,C=9@2 |"), shown);
    }

    /** On the processor's clock a wait costs nothing, so that a deadline of 1 ms leaves a whole millisecond for work. */
    @Test
    void timeOnTheProcessor() throws IOException {
        JsonNode row = bench(0, "--parts", "time", "--objects", "4", "--variants", "base", "--clock", "cpu", "--time-solver", "poss:H=9,C=99@1")
                .at("/parts/time/0");
        assertTrue(row.get("median_ms").asDouble() >= 1, row.toString());
        assertTrue(row.get("median_cpu_ms").asDouble() <= row.get("median_ms").asDouble());
        assertTrue(shown.contains("; all times on the processor\n"), shown);
    }

    @Test
    void returns() throws IOException {
        JsonNode rows = bench(0, "--parts", "return", "--domains", "bowls-and-spoons", "--episodes", "20", "--return-solver", "clairvoyant",
                "--return-solver", "random").at("/parts/return");
        assertEquals(2, rows.size());
        assertEquals(20, rows.get(1).get("episodes").asInt());
        double ceiling = rows.get(0).get("return").get(0).asDouble();
        double floor = rows.get(1).get("return").get(0).asDouble();
        assertEquals("clairvoyant", rows.get(1).get("compared_with").asText());
        assertEquals(ceiling - floor, rows.get(1).get("it_earns_more").get(0).asDouble(), 1e-9, "the mean of paired differences");
        assertTrue(rows.get(1).get("it_earns_more").get(1).asDouble() > 0, "the interval's low end");
    }

    @Test
    void burlap() throws IOException {
        JsonNode rows = bench(0, "--parts", "burlap", "--trees", "1x2", "--burlap-decisions", "2").at("/parts/burlap");
        assertEquals(2, rows.size());
        for (JsonNode row : rows) {
            assertTrue(row.get("burlap_finished").asBoolean());
            assertEquals(row.get("burlap_cpu_ms").asDouble() / row.get("poss_cpu_ms").asDouble(), row.get("ratio").asDouble(), 1e-9);
        }
    }

    /** A tree that takes BURLAP minutes is given up after a second, and the ratio is only known to be larger. */
    @Test
    void burlapIsStopped() throws IOException {
        JsonNode rows = bench(0, "--parts", "burlap", "--trees", "2x40", "--burlap-seconds", "1").at("/parts/burlap");
        assertFalse(rows.get(0).get("burlap_finished").asBoolean());
        assertTrue(shown.contains(" > "), shown);
    }

    /** Whatever else a decision allocates, further beliefs cost nothing. */
    @Test
    void allocation() throws IOException {
        JsonNode rows = bench(0, "--parts", "allocation", "--seconds", "0.5", "--decisions", "60").at("/parts/allocation");
        JsonNode large = rows.get(1);
        assertEquals("poss:H=2,C=20", large.get("solver").asText());
        assertTrue(large.get("median_bytes").asDouble() > 0);
        assertTrue(large.get("bytes_per_further_node").asDouble() < 8, "less than a number each: " + large);
    }

    @Test
    void growth() throws IOException {
        JsonNode rows = bench(0, "--parts", "growth", "--growth-objects", "3,4,5", "--growth-widths", "2,3,4", "--growth-horizons", "1,2,3")
                .at("/parts/growth");
        assertEquals(5, rows.size());
        assertEquals(3, rows.get(0).get("exponent").size());
        assertEquals(2, rows.get(4).get("factors").size());
        assertEquals(3, rows.get(4).get("median_cpu_ms").size());
    }

    /** Picks, and fails at its hundredth decision. */
    public static final class Failing implements Solver {
        @Override
        public String name() {
            return "failing";
        }

        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            AtomicInteger decisions = new AtomicInteger();
            Policy hasty = new Threshold(0).solve(domain, random);
            return (belief, deadline, chance) -> {
                if (decisions.incrementAndGet() == 100) {
                    throw new IllegalStateException("as expected");
                }
                return hasty.decide(belief, deadline, chance);
            };
        }
    }

    @Test
    void whatIsFinishedIsKept() throws IOException {
        JsonNode all = bench(1, "--parts", "allocation,return,growth", "--return-solver", Failing.class.getName());
        assertEquals("[\"allocation\"]", all.get("finished").toString());
        assertEquals(6, all.at("/parts/allocation").size());
        assertTrue(shown.contains("\n## allocation\n") && !shown.contains("## return"), shown);
        assertEquals(1, all.at("/parts/return").size(), "so far");
        assertEquals(0, all.at("/parts/return/0/episodes").asInt() % 25, "the last time that it was saved");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --parts time,space | --parts: expected some of time, return, burlap, allocation, growth, got "space"
            --seconds 0 | --seconds: expected seconds above 0, at most 3600, got 0.0
            --clock sun | --clock: expected wall or cpu (if this Java can tell), got "sun"
            --decisions 0 | --decisions: expected a whole number of at least 1, got 0
            --objects 500 | generated-500-base: expected from 1 to 200 objects
            --variants bas --objects 4 | generated-4-bas: variant: expected base
            --time-solver poss@0 | "poss@0": expected milliseconds from 1 to 3600000 after @, several as 5/20/50
            --time-solver poss@5/x | "poss@5/x": expected milliseconds
            --time-solver poss@5/5 | --time-solver: expected each solver once, got poss:H=3,C=10@5 twice
            --return-solver mcts | solver "mcts": expected one of
            --episodes 1 | --episodes: expected a whole number of at least 2, got 1
            --parts burlap --trees 3 | --trees: expected acts ahead x observations as 3x5, got "3"
            --parts growth --growth-widths 1,2 | --growth-widths: expected at least 3 different numbers, got [1, 2]
            """)
    void whatCannotBeMeantIsSaidBeforeAnythingIsMeasured(String options, String message) {
        Output o = Output.of(("bench " + options).split(" "));
        assertTrue(o.err().startsWith("handover: " + message), o.err());
        assertEquals("", o.out());
        assertEquals(Main.BAD_INPUT, o.code());
    }
}
