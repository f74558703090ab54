package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Reads the log of a bridge's session. A last line without line end was torn when the bridge was killed and is left out;
 * anything else that is wrong is an {@link EpisodeLogException} with the line. Used by one thread.
 */
public final class SessionLogReader implements Closeable {
    private final LogLines lines;
    private final SessionHeader header;
    private final HandoverDomain domain;

    /**
     * A line after the first.
     *
     * @param at when, Unix seconds
     * @param received when the message came, if it had to wait; else as {@code at}
     * @param message that was applied; null if none was
     * @param version of the belief after it
     * @param belief b after it, one entry for each object; not to be modified
     * @param human h after it, likewise
     * @param decision whether the line is a decision
     */
    public record Entry(double at, double received, WireMessage message, long version, double[] belief, double[] human, boolean decision) {}

    private SessionLogReader(LogLines lines) throws IOException {
        this.lines = lines;
        this.header = lines.header("the log of a session", SessionHeader::of);
        this.domain = DomainFiles.domain(header.domain());
    }

    /** Opens a log and reads its header. Throws {@link EpisodeLogException} if it is not one. */
    public static SessionLogReader open(Path file) throws IOException {
        return LogLines.open(file, SessionLogReader::new);
    }

    /** Whether a file begins as the log of a session does. */
    public static boolean looksLikeLog(Path file) throws IOException {
        return LogLines.begins(file, SessionHeader.FORMAT, false);
    }

    public SessionHeader header() {
        return header;
    }

    /** The domain of the header. */
    public HandoverDomain domain() {
        return domain;
    }

    /** The next line; null at the end. */
    public Entry next() throws IOException {
        JsonNode tree = lines.next();
        if (tree == null) {
            return null;
        }
        try {
            Fields f = new Fields(tree, "");
            double at = f.number("at");
            if (!f.has("message")) {
                return new Entry(at, at, null, 0, null, null, f.has("decision"));
            }
            return new Entry(at, f.has("received") ? f.number("received") : at, Messages.decode(f.object("message").node()),
                    f.whole("belief_version", 1, Long.MAX_VALUE), f.numbers("belief"), f.numbers("human_belief"), false);
        } catch (FieldException e) {
            throw lines.wrong(e);
        } catch (WireException e) {
            throw lines.wrong("message" + (e.path().isEmpty() ? "" : "." + e.path()) + ": " + e.getMessage());
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
