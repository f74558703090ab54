package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import handover.belief.HandoverBelief;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Writes the log of a bridge's session: each line with one write, so that a bridge that is killed tears at most the last one.
 * Each method throws {@link UncheckedIOException} if that fails, and leaves no part of its line behind. The file is locked: no
 * other bridge can write to it. Used by one thread at a time.
 */
public final class SessionLogWriter implements Closeable {
    private final Path file;
    private final FileChannel channel;
    /** Of the whole lines, in bytes. */
    private long length;
    /** Whether part of a line may be behind them. */
    private boolean torn;

    private SessionLogWriter(Path file, FileChannel channel, long length) {
        this.file = file;
        this.channel = channel;
        this.length = length;
    }

    private static SessionLogWriter open(Path file, long length, StandardOpenOption... options) throws IOException {
        FileChannel channel = FileChannel.open(file, options);
        try {
            lock(file, channel);
            return new SessionLogWriter(file, channel, length);
        } catch (IOException e) {
            channel.close();
            throw e;
        }
    }

    private static void lock(Path file, FileChannel channel) throws IOException {
        FileLock lock;
        try {
            lock = channel.tryLock();
        } catch (OverlappingFileLockException e) {
            lock = null;
        }
        if (lock == null) {
            throw new FileSystemException(file.toString(), null, "another bridge writes to this log");
        }
    }

    /** A new log with this header. Throws if there is such a file already, which may be needed to go on after a crash. */
    public static SessionLogWriter create(Path file, SessionHeader header) throws IOException {
        SessionLogWriter writer = open(file, 0, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        writer.write(header.json());
        return writer;
    }

    /**
     * A log that goes on after its first {@code length} bytes; a torn line beyond them is cut off. Throws
     * {@link FileSystemException} if another bridge writes to it, or has written to it since it was read.
     */
    public static SessionLogWriter append(Path file, long length) throws IOException {
        SessionLogWriter writer = open(file, length, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            writer.cut();
            return writer;
        } catch (IOException e) {
            writer.close();
            throw e;
        }
    }

    private void cut() throws IOException {
        InputStream beyond = Channels.newInputStream(channel.position(length));
        for (int b = beyond.read(); b >= 0; b = beyond.read()) {
            if (b == '\n') {
                throw new FileSystemException(file.toString(), null, "another bridge wrote to this log after it was read");
            }
        }
        channel.truncate(length);
    }

    /**
     * A message that is applied, with what is believed then.
     *
     * @param at when it is applied, Unix seconds
     * @param received when it came, likewise
     * @param message as {@link Messages#decode} took it
     * @param reply on one line; null for none
     */
    public void applied(double at, double received, byte[] message, long version, HandoverBelief belief, String reply) {
        ObjectNode tree = Json.object().put("at", at);
        if (received != at) {
            tree.put("received", received);
        }
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
        ByteBuffer line = ByteBuffer.wrap((Json.line(tree) + "\n").getBytes(StandardCharsets.UTF_8));
        try {
            mend();
            torn = true;
            long end = length;
            while (line.hasRemaining()) {
                end += channel.write(line, end);
            }
            length = end;
            torn = false;
        } catch (IOException e) {
            try {
                mend();
            } catch (IOException again) {
                e.addSuppressed(again);
            }
            throw new UncheckedIOException(NamedOutput.named(file, e));
        }
    }

    /** Until this succeeds nothing more can be written. */
    private void mend() throws IOException {
        if (torn) {
            channel.truncate(length);
            torn = false;
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
