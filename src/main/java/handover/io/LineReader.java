package handover.io;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;

/**
 * Lines of bytes, of limited length, with what a reader of text does not tell: whether the last one has an end. Used by one
 * thread.
 */
public final class LineReader implements Closeable {
    private final InputStream in;
    private final int longest;
    private long position;

    /**
     * @param content the bytes without the line end; of a longer line the first {@code longest} + 1
     * @param ended whether a line end followed
     * @param end how many bytes had been read after it
     */
    public record Line(byte[] content, boolean ended, long end) {
        public boolean isBlank() {
            for (byte b : content) {
                if (b != ' ' && b != '\t' && b != '\r') {
                    return false;
                }
            }
            return true;
        }
    }

    /** @param longest bytes of a line that are kept, but for one more by which it shows that it is longer */
    public LineReader(InputStream in, int longest) {
        this.in = new BufferedInputStream(in);
        this.longest = longest;
    }

    /** The next line; null at the end. */
    public Line next() throws IOException {
        ByteArrayOutputStream content = new ByteArrayOutputStream();
        long start = position;
        int b = in.read();
        while (b >= 0 && b != '\n') {
            position++;
            if (content.size() <= longest) {
                content.write(b);
            }
            b = in.read();
        }
        boolean ended = b == '\n';
        position += ended ? 1 : 0;
        return position == start ? null : new Line(content.toByteArray(), ended, position);
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
