package handover.cli;

import handover.io.EpisodeLogReader;
import handover.io.EpisodeLogWriter;
import handover.io.LoggedEpisode;
import handover.io.RunHeader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The file that a run is logged to.
 *
 * @param file may exist
 * @param console for notices
 */
record LogFile(Path file, Console console) {

    /** Throws {@link UsageException} if the file is there and is not an episode log, which would be lost. */
    void checkReplaceable() throws IOException {
        if (Files.exists(file) && !EpisodeLogReader.looksLikeLog(file)) {
            throw new UsageException(file + ": is not an episode log and will not be overwritten; choose another --out");
        }
    }

    /** A new log, in place of an old one. */
    EpisodeLogWriter create(RunHeader header) throws IOException {
        checkReplaceable();
        return EpisodeLogWriter.create(file, header);
    }

    /** A log that goes on where the file ends; what is finished there is told to the run. */
    EpisodeLogWriter resume(RunHeader header, Run run) throws IOException {
        checkReplaceable();
        if (!Files.exists(file) || EpisodeLogReader.withoutHeader(file)) {
            console.err().println("nothing to resume in " + file + ", this run starts from the beginning");
            return EpisodeLogWriter.create(file, header);
        }
        try (EpisodeLogReader reader = EpisodeLogReader.open(file)) {
            if (!reader.header().equals(header)) {
                throw new UsageException(file + ": is the log of another run (" + different(reader.header(), header)
                        + "), which cannot be resumed with these options");
            }
            long end = read(reader, run);
            console.err().println("resuming " + file + ": " + run.done() + " of " + run.total() + " episodes are finished"
                    + (reader.torn() ? "; its last line was torn and is played again" : ""));
            return EpisodeLogWriter.append(file, end);
        }
    }

    private static long read(EpisodeLogReader reader, Run run) throws IOException {
        long end = reader.end();
        for (LoggedEpisode e = reader.next(); e != null; e = reader.next()) {
            if (!run.expects(e.solver(), e.index())) {
                throw reader.wrong("episode " + e.index() + " of " + e.solver() + " is not the one that comes next");
            }
            run.skip(e.solver(), e.index(), e.wanted(), e.measures());
            end = reader.end();
        }
        return end;
    }

    private static String different(RunHeader log, RunHeader now) {
        if (!log.domain().equals(now.domain())) {
            return "another domain";
        } else if (!log.people().equals(now.people())) {
            return "other people";
        } else if (log.seed() != now.seed()) {
            return "seed " + log.seed();
        } else if (!log.solvers().equals(now.solvers())) {
            return "solvers " + String.join(" ", log.solvers());
        } else if (log.episodes() != now.episodes()) {
            return log.episodes() + " episodes";
        }
        if (log.maxSteps() != now.maxSteps()) {
            return "at most " + log.maxSteps() + " steps";
        }
        return log.deadlineMs() != now.deadlineMs() ? "another deadline" : "timed";
    }
}
