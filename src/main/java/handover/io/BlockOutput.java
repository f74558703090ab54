package handover.io;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.util.zip.CRC32C;

/**
 * Writes numbers, little-endian, in blocks of {@link #BLOCK} bytes, each followed by its CRC-32C; at the end the CRC-32C of all
 * that was written. Used by one thread.
 */
final class BlockOutput implements Closeable {
    static final int BLOCK = 1 << 20;

    private final FileChannel channel;
    private final CRC32C whole = new CRC32C();
    private final ByteBuffer block = ByteBuffer.allocate(BLOCK + Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);

    /** @param channel at the position where to write; closed with this */
    BlockOutput(FileChannel channel) {
        this.channel = channel;
    }

    /** Bytes as they are, outside of any block; only before the first number. */
    void raw(byte[] bytes) throws IOException {
        whole.update(bytes);
        write(ByteBuffer.wrap(bytes));
    }

    void put(int value) throws IOException {
        block.putInt(value);
        if (block.position() == BLOCK) {
            flush();
        }
    }

    void put(float[] values, int from, int count) throws IOException {
        for (int k = from; k < from + count; k++) {
            put(Float.floatToRawIntBits(values[k]));
        }
    }

    /** Ends the last block and adds the checksum of the whole, then waits until all is on the disk. */
    void finish() throws IOException {
        if (block.position() > 0) {
            flush();
        }
        ByteBuffer end = ByteBuffer.allocate(Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN).putInt((int) whole.getValue());
        write(end.flip());
        channel.force(true);
    }

    private void flush() throws IOException {
        CRC32C crc = new CRC32C();
        crc.update(block.array(), 0, block.position());
        block.putInt((int) crc.getValue());
        whole.update(block.array(), 0, block.position());
        write(block.flip());
        block.clear();
    }

    private void write(ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
