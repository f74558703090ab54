package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * The lines of a log as JSON trees. A last line without line end was torn when the writer was stopped and is left out. Used by
 * one thread.
 */
final class LogLines implements Closeable {
    private static final int LONGEST_LINE = 1 << 28;

    private final String file;
    private final LineReader lines;
    private int number;
    private long end;
    private boolean torn;

    /** What reads a log from its first line on. */
    @FunctionalInterface
    interface Reader<R> {
        R of(LogLines lines) throws IOException;
    }

    /** Opens a log, and closes it again if its first line is not that of one. Throws {@link EpisodeLogException} then. */
    static <R> R open(Path file, Reader<R> reader) throws IOException {
        LogLines lines = new LogLines(file);
        try {
            return reader.of(lines);
        } catch (IOException | RuntimeException e) {
            lines.close();
            throw e;
        }
    }

    /**
     * Whether a file begins as the logs of a format do.
     *
     * @param torn whether it may end before that can be told
     */
    static boolean begins(Path file, String format, boolean torn) throws IOException {
        byte[] expected = ("{\"format\":\"" + format + "\"").getBytes(StandardCharsets.UTF_8);
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] got = in.readNBytes(expected.length);
            return Arrays.equals(got, torn ? Arrays.copyOf(expected, got.length) : expected);
        }
    }

    /** Throws {@link EpisodeLogException} if there is no such file. */
    private LogLines(Path file) throws IOException {
        this.file = file.toString();
        if (Files.isDirectory(file)) {
            throw new EpisodeLogException(this.file, 0, "is a directory, not a file", null);
        }
        try {
            this.lines = new LineReader(Files.newInputStream(file), LONGEST_LINE);
        } catch (NoSuchFileException e) {
            throw new EpisodeLogException(this.file, 0, "there is no such file", e);
        }
    }

    /** What makes a header of the first line, in a place of which messages may speak. */
    @FunctionalInterface
    interface Header<H> {
        H of(JsonNode tree, String place);
    }

    /** The header. Throws {@link EpisodeLogException} if the first line is none. */
    <H> H header(String what, Header<H> of) throws IOException {
        JsonNode tree = first(what);
        try {
            return of.of(tree, place());
        } catch (FieldException e) {
            throw wrong(e);
        } catch (DomainFileException e) {
            throw wrong(e);
        }
    }

    private JsonNode first(String what) throws IOException {
        JsonNode tree = next();
        if (tree == null) {
            throw new EpisodeLogException(file, 0, "expected " + what + ", got "
                    + (torn ? "no complete line" : "an empty file"), null);
        }
        return tree;
    }

    /** The next line; null at the end. Throws {@link EpisodeLogException} if it is not JSON. */
    JsonNode next() throws IOException {
        LineReader.Line line = lines.next();
        torn = line != null && !line.ended();
        if (line == null || torn) {
            return null;
        }
        number++;
        end = line.end();
        try {
            return JsonText.parseLog(line.content(), place());
        } catch (DomainFileException e) {
            throw wrong(e);
        }
    }

    /** What messages call the line that was read last. */
    String place() {
        return file + ": line " + number;
    }

    /** An exception about the line that was read last. */
    EpisodeLogException wrong(String problem) {
        return new EpisodeLogException(file, number, problem, null);
    }

    EpisodeLogException wrong(FieldException e) {
        return new EpisodeLogException(file, number, e.path().isEmpty() ? e.getMessage() : e.path() + ": " + e.getMessage(),
                e);
    }

    EpisodeLogException wrong(DomainFileException e) {
        String problem = e.getMessage().substring((place() + ": ").length()).replaceFirst("^line 1, ", "");
        return new EpisodeLogException(file, number, problem, e);
    }

    /** Whether the last line was torn; known once {@link #next} has given null. */
    boolean torn() {
        return torn;
    }

    /** How many bytes there are up to the end of the line that was read last. */
    long end() {
        return end;
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}
