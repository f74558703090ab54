package handover.cli;

import handover.solver.Deadline;
import java.util.random.RandomGenerator;

/** Chance until a deadline: how to stop a planner that draws all the time but knows of no deadlines. */
record LimitedChance(RandomGenerator chance, Deadline deadline) implements RandomGenerator {

    /** There is no more chance. */
    static final class TimeIsUpException extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    /** Throws {@link TimeIsUpException} once the deadline has passed. */
    @Override
    public long nextLong() {
        if (deadline.passed()) {
            throw new TimeIsUpException();
        }
        return chance.nextLong();
    }
}
