package handover.io;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;

/**
 * A file to write to. What goes wrong after it was opened, as on a full disk, is an {@link IOException} with its name. Used by
 * one thread at a time.
 */
public final class NamedOutput extends OutputStream {
    private final Path file;
    private final OutputStream out;

    private NamedOutput(Path file, OutputStream out) {
        this.file = file;
        this.out = out;
    }

    /** @param options as for {@link Files#newOutputStream}: with none, the file is made, or made empty */
    static NamedOutput open(Path file, OpenOption... options) throws IOException {
        return new NamedOutput(file, Files.newOutputStream(file, options));
    }

    /** A new text file in UTF-8, in place of the file if there is one. */
    public static BufferedWriter text(Path file) throws IOException {
        return new BufferedWriter(new OutputStreamWriter(open(file), StandardCharsets.UTF_8));
    }

    @FunctionalInterface
    private interface Operation {
        void run() throws IOException;
    }

    private void named(Operation operation) throws IOException {
        try {
            operation.run();
        } catch (IOException e) {
            throw named(file, e);
        }
    }

    /** What went wrong with a file, with its name in the message. */
    static IOException named(Path file, IOException e) {
        return e instanceof FileSystemException ? e : new IOException(file + ": " + e.getMessage(), e);
    }

    @Override
    public void write(int b) throws IOException {
        named(() -> out.write(b));
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
        named(() -> out.write(bytes, from, count));
    }

    @Override
    public void flush() throws IOException {
        named(out::flush);
    }

    @Override
    public void close() throws IOException {
        named(out::close);
    }
}
