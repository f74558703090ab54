package handover.contract;

import handover.solver.Solver;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Everything that a solver must keep. A solver is put under it by three lines:
 *
 * <pre>{@code
 * class AskOnceTest extends SolverContract {
 *     protected Solver solver() { return new AskOnce(); }
 * }
 * }</pre>
 *
 * Each rule of {@link SolverRules} is a test; a failure names the rule, the solver and the belief.
 */
public abstract class SolverContract {
    /** The solver, with parameters that decide within a fraction of a second. */
    protected abstract Solver solver();

    /** The domains that it is tried on, by name or file. */
    protected List<String> domains() {
        return List.of("bowls-and-spoons", "bowls-incremental", "bowls-communicated", "bowls-nested");
    }

    @TestFactory
    Stream<DynamicTest> keeps() {
        return SolverRules.ALL.stream()
                .map(rule -> DynamicTest.dynamicTest(rule.toString(), () -> rule.check(solver(), domains())));
    }
}
