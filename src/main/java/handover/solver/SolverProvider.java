package handover.solver;

/**
 * A kind of solver that lives outside of this package because making it needs more than this package may use, for instance
 * files. {@link Solvers#parse} finds implementations as Java services ({@code META-INF/services/handover.solver.SolverProvider}).
 * Implementations have a public constructor without arguments and are immutable.
 */
public interface SolverProvider {
    /** What comes before the colon. */
    String name();

    /** Parameters and what they do, in one line. */
    String description();

    /**
     * The solver that a specification asks for.
     *
     * @param spec as written, beginning with {@link #name}
     * @throws IllegalArgumentException that says what was expected
     */
    Solver make(String spec);
}
