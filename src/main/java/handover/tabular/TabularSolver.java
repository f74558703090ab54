package handover.tabular;

import java.util.random.RandomGenerator;

/** A way to solve tabular POMDPs; a record of parameters. Immutable, thread safe. */
public interface TabularSolver {
    /** As written on the command line, with its parameters. */
    String name();

    /**
     * Does the offline work, if there is any.
     *
     * @throws IllegalArgumentException if this solver cannot solve such a problem
     */
    TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random);
}
