package handover.cli;

import handover.solver.Deadline;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/** Deadlines on a clock. */
final class Deadlines {
    private static final long NANOS = 1_000_000;

    private Deadlines() {}

    /** Gives deadlines that pass so many milliseconds after they were asked for; 0 for none. */
    static Supplier<Deadline> after(int milliseconds, LongSupplier nanoClock) {
        if (milliseconds == 0) {
            return () -> Deadline.NONE;
        }
        return () -> {
            long start = nanoClock.getAsLong();
            return () -> nanoClock.getAsLong() - start >= milliseconds * NANOS;
        };
    }
}
