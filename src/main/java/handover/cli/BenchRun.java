package handover.cli;

import java.util.function.LongSupplier;

/**
 * What all parts of a bench share.
 *
 * @param clock what times and limits are measured by, in nanoseconds
 * @param seconds for measuring one contender in one place
 * @param decisions of each contender in one place, at most
 * @param seed of beliefs, episodes and luck
 */
record BenchRun(Console console, BenchReport report, LongSupplier clock, double seconds, int decisions, long seed) {
    /** More beliefs are not made; decisions go round. */
    private static final int MOST_BELIEFS = 500;

    /** Different beliefs to decide at. */
    int beliefs() {
        return Math.min(decisions, MOST_BELIEFS);
    }

    /** For so many times {@link #decisions} rounds. */
    Progress progress(String what, int times) {
        return new Progress(console, what, 0, (long) times * decisions);
    }
}
