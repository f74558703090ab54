package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.simulation.Episode;
import handover.simulation.TimedEpisode;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Writes an episode log: each line with one write, so that a run that is stopped tears at most the last one. Used by one
 * thread at a time.
 */
public final class EpisodeLogWriter implements Closeable {
    private final OutputStream out;

    private EpisodeLogWriter(OutputStream out) {
        this.out = out;
    }

    /** A new log with this header, in place of the file if there is one. */
    public static EpisodeLogWriter create(Path file, RunHeader header) throws IOException {
        EpisodeLogWriter writer = new EpisodeLogWriter(NamedOutput.open(file));
        writer.write(Json.line(header.json()));
        return writer;
    }

    /** A log that goes on after its first {@code length} bytes; what the file has beyond them is cut off. */
    public static EpisodeLogWriter append(Path file, long length) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.truncate(length);
        }
        return new EpisodeLogWriter(NamedOutput.open(file, StandardOpenOption.APPEND));
    }

    /** Adds an episode. Throws {@link UncheckedIOException} if that fails. */
    public void write(Episode episode) {
        add(EpisodeJson.tree(episode));
    }

    /** Adds a timed episode of an agent. Throws {@link UncheckedIOException} if that fails. */
    public void write(TimedEpisode episode, String agent) {
        add(EpisodeJson.tree(episode, agent));
    }

    private void add(ObjectNode tree) {
        try {
            write(Json.line(tree));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void write(String line) throws IOException {
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
