package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.math.Streams;
import handover.simulation.Estimate;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongUnaryOperator;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;

/** What measurements say, by a clock that only solvers move. */
class MeasurementTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("bowls-and-spoons");
    private static final long MS = 1_000_000;

    private final AtomicLong now = new AtomicLong();

    /** Takes as many milliseconds at its k-th decision as it is told; whether it finishes depends on the deadline. */
    private final class Slow implements Solver {
        private final LongUnaryOperator ms;
        private final AtomicInteger decisions = new AtomicInteger();

        Slow(LongUnaryOperator ms) {
            this.ms = ms;
        }

        @Override
        public String name() {
            return "slow";
        }

        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            return (belief, deadline, chance) -> {
                now.addAndGet(MS * ms.applyAsLong(decisions.getAndIncrement()));
                return new Decision(Act.WAIT, Map.of(), 2, 7, !deadline.passed());
            };
        }
    }

    private DecisionTimes times(Solver solver, int limit) {
        List<HandoverBelief> beliefs = BenchBeliefs.of(DOMAIN, 20, 1);
        return new DecisionTimes(new Contender(solver, limit), DOMAIN, beliefs, 1, now::get);
    }

    /** 200 decisions of 1 to 10 ms in turn, in a second of which half is warm-up. */
    @Test
    void percentilesAndLateness() {
        DecisionTimes t = times(new Slow(k -> 1 + k % 10), 8);
        DecisionTimes.measure(List.of(t), 200, 100, () -> {});
        assertEquals(200, t.decisions());
        assertEquals(5, t.ms().median());
        assertEquals(9, t.ms().p90());
        assertEquals(10, t.ms().max());
        assertEquals(0, t.late().median());
        assertEquals(2, t.late().max());
        assertEquals(7, t.nodes().median());
        assertEquals(0.7, (double) t.row().get("finished_share"), 1e-9, "1 to 7 of 10 end before the limit of 8 ms");
    }

    @Test
    void theSlowAreOutAfterTheirTime() {
        DecisionTimes slow = times(new Slow(k -> 100), 0);
        DecisionTimes fast = times(new Slow(k -> 1), 0);
        AtomicInteger rounds = new AtomicInteger();
        DecisionTimes.measure(List.of(slow, fast), 50, 0.95, rounds::incrementAndGet);
        assertEquals(10, slow.decisions(), "about a second in all");
        assertEquals(50, fast.decisions());
        assertEquals(50, rounds.get());
    }

    @Test
    void whatTakesLongerThanAnybodyWaitsIsNotMeasured() {
        DecisionTimes t = times(new Slow(k -> 11_000), 0);
        DecisionTimes.measure(List.of(t), 50, 1, () -> {});
        assertTrue(!t.measured());
        assertEquals(10_000, t.row().get("longer_than_ms"));
    }

    @Test
    void nearestRanks() {
        Spread s = new Spread(List.of(5, 1, 4, 2, 3));
        assertEquals(List.of(1.0, 1.0, 2.0, 3.0, 5.0, 5.0), List.of(s.at(0), s.at(0.2), s.at(0.21), s.median(), s.p99(), s.max()));
        assertThrows(IllegalArgumentException.class, () -> new Spread(List.of()));
    }

    @Test
    void laws() {
        Estimate square = BenchGrowth.exponent(Map.of(2, 12.0, 4, 48.0, 10, 300.0));
        assertEquals(2, square.value(), 1e-9);
        assertEquals(2, square.low(), 1e-6);
        Map<Integer, Double> points = new LinkedHashMap<>();
        points.put(1, 2.0);
        points.put(2, 10.0);
        points.put(4, 90.0);
        assertEquals(List.of(5.0, 3.0), BenchGrowth.factors(points));
    }

    @Test
    void chanceEndsWithTheTime() {
        AtomicBoolean passed = new AtomicBoolean();
        RandomGenerator chance = new LimitedChance(Streams.of(1, "x", 0), passed::get);
        assertEquals(Streams.of(1, "x", 0).nextDouble(), chance.nextDouble());
        passed.set(true);
        assertThrows(LimitedChance.TimeIsUpException.class, chance::nextDouble);
    }

    @Test
    void tablesLineUp() {
        MarkdownTable table = new MarkdownTable("who", "ms");
        table.add("me", 1);
        table.add("somebody", 1000);
        assertEquals("""
                | who      |   ms |
                |----------|-----:|
                | me       |    1 |
                | somebody | 1000 |
                """, table.text());
    }
}
