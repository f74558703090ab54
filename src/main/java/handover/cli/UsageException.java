package handover.cli;

/** A command line that cannot be meant. */
final class UsageException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    UsageException(String problem) {
        super(problem);
    }

    /** Throws unless an option's value is in its range. */
    static void checkAtLeast(String option, long value, long least) {
        if (value < least) {
            throw new UsageException(option + ": expected a whole number of at least " + least + ", got " + value);
        }
    }
}
