package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads an episode log, one episode at a time. A last line without line end was torn when the run was stopped and is left
 * out; anything else that is wrong is an {@link EpisodeLogException} with the line. Used by one thread.
 */
public final class EpisodeLogReader implements Closeable {
    private final LogLines lines;
    private final RunHeader header;
    private final HandoverDomain domain;

    private EpisodeLogReader(LogLines lines) throws IOException {
        this.lines = lines;
        this.header = lines.header("an episode log", RunHeader::of);
        this.domain = DomainFiles.domain(header.domain());
    }

    /** Opens a log and reads its header. Throws {@link EpisodeLogException} if it is not one. */
    public static EpisodeLogReader open(Path file) throws IOException {
        return LogLines.open(file, EpisodeLogReader::new);
    }

    /** Whether a file begins as an episode log does, even if it was torn within the first line; an empty file does. */
    public static boolean looksLikeLog(Path file) throws IOException {
        return LogLines.begins(file, RunHeader.FORMAT, true);
    }

    /** Whether a log was torn within its first line, so that there is nothing in it yet. */
    public static boolean withoutHeader(Path file) throws IOException {
        try (LineReader lines = new LineReader(Files.newInputStream(file), 0)) {
            LineReader.Line first = lines.next();
            return first == null || !first.ended();
        }
    }

    public RunHeader header() {
        return header;
    }

    /** The domain of the header, as the robot sees it. */
    public HandoverDomain domain() {
        return domain;
    }

    /** The next episode; null at the end. */
    public LoggedEpisode next() throws IOException {
        JsonNode tree = lines.next();
        try {
            return tree == null ? null : EpisodeJson.episode(tree, domain.vocabulary(), header.time() != null);
        } catch (FieldException e) {
            throw lines.wrong(e);
        }
    }

    /** An exception about the line that was read last. */
    public EpisodeLogException wrong(String problem) {
        return lines.wrong(problem);
    }

    /** Whether the last line was torn; known once {@link #next} has given null. */
    public boolean torn() {
        return lines.torn();
    }

    /** How many bytes there are up to the end of the line that was read last. */
    public long end() {
        return lines.end();
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}
