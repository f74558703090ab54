package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import handover.belief.HandoverBelief;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Writes the log of a bridge's session: each line with one write, so that a bridge that is killed tears at most the last one.
 * Each method throws {@link UncheckedIOException} if that fails. Used by one thread at a time.
 */
public final class SessionLogWriter implements Closeable {
    private final OutputStream out;

    private SessionLogWriter(OutputStream out) {
        this.out = out;
    }

    /** A new log with this header. Throws if there is such a file already, which may be needed to go on after a crash. */
    public static SessionLogWriter create(Path file, SessionHeader header) throws IOException {
        SessionLogWriter writer = new SessionLogWriter(NamedOutput.open(file, StandardOpenOption.CREATE_NEW));
        writer.write(header.json());
        return writer;
    }

    /** A log that goes on after its first {@code length} bytes; what the file has beyond them is cut off. */
    public static SessionLogWriter append(Path file, long length) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.truncate(length);
        }
        return new SessionLogWriter(NamedOutput.open(file, StandardOpenOption.APPEND));
    }

    /**
     * A message that is applied, with what is believed then.
     *
     * @param at when it came, Unix seconds
     * @param message as {@link Messages#decode} took it
     * @param reply on one line; null for none
     */
    public void applied(double at, byte[] message, long version, HandoverBelief belief, String reply) {
        ObjectNode tree = Json.object().put("at", at);
        tree.putRawValue("message", raw(JsonText.decode(message, "message")));
        tree.put("belief_version", version);
        tree.set("belief", Json.list(belief.probabilities()));
        tree.set("human_belief", Json.list(belief.human()));
        write(reply == null ? tree : tree.putRawValue("reply", raw(reply)));
    }

    /** A decision that is answered; {@code reply} is on one line. */
    public void decided(double at, String reply) {
        write(Json.object().put("at", at).putRawValue("decision", raw(reply)));
    }

    /** An answer that changes nothing, on one line. */
    public void replied(double at, String reply) {
        write(Json.object().put("at", at).putRawValue("reply", raw(reply)));
    }

    /** JSON on one line: line ends are white space wherever JSON may have them. */
    private static RawValue raw(String json) {
        return new RawValue(json.replace('\n', ' ').replace('\r', ' '));
    }

    private void write(ObjectNode tree) {
        try {
            out.write((Json.line(tree) + "\n").getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
