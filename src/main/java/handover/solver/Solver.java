package handover.solver;

import handover.domain.HandoverDomain;
import java.util.random.RandomGenerator;

/** A way to solve handover problems; a record of parameters. Immutable, thread safe. */
public interface Solver {
    /** As written on the command line, with its parameters. */
    String name();

    /** Does the offline work, if there is any. */
    Policy solve(HandoverDomain domain, RandomGenerator random);

    /** Whether its policies are to be shown what the human wants: a ceiling, not a planner. */
    default boolean clairvoyant() {
        return false;
    }
}
