package handover.contract;

import handover.solver.Solver;
import java.util.List;
import java.util.function.Consumer;

/**
 * One rule of the solvers' contract.
 *
 * @param number for reference
 * @param name what must hold
 * @param body throws an AssertionError, or anything else, where it does not
 */
public record SolverRule(int number, String name, Consumer<Trial> body) {

    /**
     * Throws an AssertionError that names the rule if the solver breaks it.
     *
     * @param domains names or files of domains
     */
    public void check(Solver solver, List<String> domains) {
        try {
            for (String domain : domains) {
                body.accept(new Trial(solver, domain));
            }
        } catch (AssertionError | RuntimeException e) {
            throw new AssertionError(this + ", " + solver.name() + ": " + e.getMessage(), e);
        }
    }

    @Override
    public String toString() {
        return "rule " + number + " (" + name + ")";
    }
}
