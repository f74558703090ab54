package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads an episode log, one episode at a time. A last line without line end was torn when the run was stopped and is left
 * out; anything else that is wrong is an {@link EpisodeLogException} with the line. Used by one thread.
 */
public final class EpisodeLogReader implements Closeable {
    private static final int LONGEST_LINE = 1 << 28;
    private static final String BEGINNING = "{\"format\":\"" + RunHeader.FORMAT + "\"";

    private final String file;
    private final LineReader lines;
    private final RunHeader header;
    private final HandoverDomain domain;
    private int number;
    private long end;
    private boolean torn;

    private EpisodeLogReader(String file, LineReader lines) throws IOException {
        this.file = file;
        this.lines = lines;
        JsonNode first = nextTree();
        if (first == null) {
            throw new EpisodeLogException(this.file, 0, "expected an episode log, got "
                    + (torn ? "no complete line" : "an empty file"), null);
        }
        this.header = header(first);
        this.domain = DomainFiles.domain(header.domain());
    }

    /** Opens a log and reads its header. Throws {@link EpisodeLogException} if it is not one. */
    public static EpisodeLogReader open(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new EpisodeLogException(file.toString(), 0, "is a directory, not a file", null);
        }
        LineReader lines = null;
        try {
            lines = new LineReader(Files.newInputStream(file), LONGEST_LINE);
            return new EpisodeLogReader(file.toString(), lines);
        } catch (NoSuchFileException e) {
            throw new EpisodeLogException(file.toString(), 0, "there is no such file", e);
        } catch (RuntimeException e) {
            lines.close();
            throw e;
        }
    }

    /** Whether a file begins as an episode log does, even if it was torn within the first line; an empty file does. */
    public static boolean looksLikeLog(Path file) throws IOException {
        byte[] expected = BEGINNING.getBytes(StandardCharsets.UTF_8);
        try (var in = Files.newInputStream(file)) {
            byte[] got = in.readNBytes(expected.length);
            return Arrays.equals(got, Arrays.copyOf(expected, got.length));
        }
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
        JsonNode tree = nextTree();
        try {
            return tree == null ? null : EpisodeJson.episode(tree, domain.vocabulary());
        } catch (FieldException e) {
            throw wrong(e);
        }
    }

    /** An exception about the line that was read last. */
    public EpisodeLogException wrong(String problem) {
        return new EpisodeLogException(file, number, problem, null);
    }

    /** Whether the last line was torn; known once {@link #next} has given null. */
    public boolean torn() {
        return torn;
    }

    /** How many bytes there are up to the end of the line that was read last. */
    public long end() {
        return end;
    }

    private JsonNode nextTree() throws IOException {
        LineReader.Line line = lines.next();
        torn = line != null && !line.ended();
        if (line == null || torn) {
            return null;
        }
        number++;
        end = line.end();
        try {
            return JsonText.parse(line.content(), file + ": line " + number);
        } catch (DomainFileException e) {
            String problem = e.getMessage().substring(e.file().length() + 2).replaceFirst("^line 1, ", "");
            throw new EpisodeLogException(file, number, problem, e);
        }
    }

    private RunHeader header(JsonNode first) {
        try {
            return RunHeader.of(first, file + ": line " + number);
        } catch (FieldException e) {
            throw wrong(e);
        } catch (DomainFileException e) {
            throw new EpisodeLogException(file, number, e.getMessage().substring((file + ": line " + number + ": ").length()),
                    e);
        }
    }

    private EpisodeLogException wrong(FieldException e) {
        return new EpisodeLogException(file, number, e.path().isEmpty() ? e.getMessage() : e.path() + ": " + e.getMessage(),
                e);
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}
