package handover.cli;

/** A command line that cannot be meant. */
final class UsageException extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private static final int MOST_THREADS = 1024;

    UsageException(String problem) {
        super(problem);
    }

    /** Throws unless an option's value is in its range. */
    static void checkAtLeast(String option, long value, long least) {
        if (value < least) {
            throw new UsageException(option + ": expected a whole number of at least " + least + ", got " + value);
        }
    }

    /** Throws unless there can be so many threads. */
    static void checkThreads(int threads) {
        checkAtLeast("--threads", threads, 1);
        if (threads > MOST_THREADS) {
            throw new UsageException("--threads: expected a whole number of at most " + MOST_THREADS + ", got " + threads);
        }
    }
}
