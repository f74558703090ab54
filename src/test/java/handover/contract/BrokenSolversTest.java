package handover.contract;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** The contract can fail: every rule has a solver that breaks it, and the failure names the rule. */
class BrokenSolversTest {
    private static final List<String> DOMAINS = List.of("bowls-and-spoons");

    /** A solver and the rule that it must fail. */
    private record Broken(String what, int rule, Solver solver) {}

    /** A solver with this name that makes its policies in this way. */
    private record Made(String name, Supplier<Policy> make) implements Solver {
        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            return make.get();
        }
    }

    private static Solver solver(Supplier<Policy> make) {
        return new Made("broken", make);
    }

    private static Decision wait(Map<Act, Double> values) {
        return new Decision(Act.WAIT, values, 0, 1, true);
    }

    private static Decision counted(long nodes) {
        return new Decision(Act.WAIT, Map.of(), 0, nodes, true);
    }

    private static Stream<Broken> broken() {
        return Stream.of(
                new Broken("reaches for what is gone", 1, solver(() -> (b, d, r) -> Decision.of(Act.of("PICK", "metal_bowl")))),
                new Broken("does not know what to do", 1, solver(() -> (b, d, r) -> null)),
                new Broken("has nothing to say in time", 2, solver(() -> (b, d, r) -> d.passed() ? null : Decision.of(Act.WAIT))),
                new Broken("complains about the deadline", 2, solver(() -> (b, d, r) -> {
                    if (d.passed() || d.passed()) {
                        throw new IllegalStateException("too late");
                    }
                    return Decision.of(Act.WAIT);
                })),
                new Broken("values that are no numbers", 3, solver(() -> (b, d, r) -> wait(Map.of(Act.WAIT, Double.NaN)))),
                new Broken("bounds that were never reached", 3, solver(() -> (b, d, r) ->
                        wait(d.passed() ? Map.of(Act.WAIT, Double.NEGATIVE_INFINITY) : Map.of()))),
                new Broken("values of acts that cannot be done", 3, solver(() -> (b, d, r) -> wait(Map.of(Act.of("PICK", "moon"), 1.0)))),
                new Broken("chance of its own", 4, solver(() -> {
                    RandomGenerator own = new SplittableRandom();
                    return (b, d, r) -> counted(own.nextLong());
                })),
                new Broken("counts its decisions", 5, solver(() -> {
                    AtomicInteger decisions = new AtomicInteger();
                    return (b, d, r) -> counted(decisions.incrementAndGet());
                })),
                new Broken("remembers that it was late once", 5, solver(() -> {
                    AtomicBoolean late = new AtomicBoolean();
                    return (b, d, r) -> {
                        late.compareAndSet(false, d.passed());
                        return counted(late.get() ? 1 : 2);
                    };
                })),
                new Broken("works in the belief's own array", 6, solver(() -> (b, d, r) -> {
                    b.probabilities()[0] /= 2;
                    return Decision.of(Act.WAIT);
                })),
                new Broken("works in what the human believes", 6, solver(() -> (b, d, r) -> {
                    b.human()[0] /= 2;
                    return Decision.of(Act.WAIT);
                })),
                new Broken("one buffer for all threads", 7, solver(OneBuffer::new)),
                new Broken("a name with a space", 8, new Made("my solver", () -> new Threshold(0.9).solve(null, null))),
                new Broken("the name of another solver", 8, new Made("confirm", () -> new Threshold(0.9).solve(null, null))));
    }

    /** Writes the belief down, dreams, and reads it. */
    private static final class OneBuffer implements Policy {
        private volatile HandoverBelief buffer;

        @Override
        public Decision decide(HandoverBelief belief, handover.solver.Deadline deadline, RandomGenerator random) {
            buffer = belief;
            for (int k = 0; k < 100 && buffer == belief; k++) {
                Thread.yield();
            }
            return counted(buffer.hashCode());
        }
    }

    @TestFactory
    Stream<DynamicTest> failsWithTheRightRule() {
        return broken().map(b -> DynamicTest.dynamicTest(b.what(), () -> {
            SolverRule rule = SolverRules.ALL.get(b.rule() - 1);
            AssertionError e = assertThrows(AssertionError.class, () -> rule.check(b.solver(), DOMAINS));
            assertTrue(e.getMessage().startsWith("rule " + b.rule() + " ("), e.getMessage());
        }));
    }

    @TestFactory
    Stream<DynamicTest> everyRuleHasABrokenSolver() {
        return SolverRules.ALL.stream().map(rule -> DynamicTest.dynamicTest(rule.toString(), () ->
                assertTrue(broken().anyMatch(b -> b.rule() == rule.number()))));
    }
}
