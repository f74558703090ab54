package handover.cli;

import java.io.IOException;

/** One part of {@link Bench}, with the options that only it has. */
interface BenchPart {
    /** As it is asked for. */
    String name();

    /** Checks the options; throws {@link UsageException}, or what says that a domain or a solver cannot be meant. */
    void check();

    /**
     * Measures, adds rows to the report as they come, and gives what people are to read: headline and Markdown table.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    String run(BenchRun run) throws IOException, InterruptedException;
}
