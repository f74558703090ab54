package handover.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.util.zip.CRC32C;

/**
 * Reads what {@link BlockOutput} wrote, block by block, each checked before any number of it is handed out. Used by one thread.
 */
final class BlockInput {
    private final FileChannel channel;
    private final CRC32C whole = new CRC32C();
    private final ByteBuffer block;
    private long left;
    private int number;

    /** Bytes that are not what was written. */
    static final class DamagedException extends IOException {
        private static final long serialVersionUID = 1L;

        DamagedException(String problem) {
            super(problem);
        }
    }

    /**
     * @param channel at the first block; not closed
     * @param before the bytes in front of it
     * @param numbers bytes of numbers in the blocks
     */
    BlockInput(FileChannel channel, byte[] before, long numbers) throws IOException {
        this.channel = channel;
        this.left = numbers;
        whole.update(before);
        long expected = before.length + stored(numbers) + Integer.BYTES;
        if (channel.size() != expected) {
            throw new DamagedException("expected " + expected + " bytes, found " + channel.size()
                    + (channel.size() < expected ? ": the file is truncated" : ""));
        }
        int largest = (int) Math.min(numbers, BlockOutput.BLOCK) + Integer.BYTES;
        block = ByteBuffer.allocateDirect(largest).order(ByteOrder.LITTLE_ENDIAN).limit(0);
    }

    private static long stored(long numbers) {
        long blocks = (numbers + BlockOutput.BLOCK - 1) / BlockOutput.BLOCK;
        return numbers + blocks * Integer.BYTES;
    }

    /** The next four bytes. */
    int next() throws IOException {
        if (!block.hasRemaining()) {
            fill();
        }
        return block.getInt();
    }

    /** The next {@code count} floats into {@code out} (modified). */
    void next(float[] out, int from, int count) throws IOException {
        int done = 0;
        while (done < count) {
            if (!block.hasRemaining()) {
                fill();
            }
            int some = Math.min(count - done, block.remaining() / Float.BYTES);
            for (int k = 0; k < some; k++) {
                out[from + done + k] = block.getFloat();
            }
            done += some;
        }
    }

    private void fill() throws IOException {
        int size = (int) Math.min(left, BlockOutput.BLOCK);
        if (size == 0) {
            throw new DamagedException("the numbers end too soon");
        }
        read(size + Integer.BYTES);
        whole.update(block.duplicate());
        CRC32C crc = new CRC32C();
        crc.update(block.duplicate().limit(size));
        if (block.getInt(size) != (int) crc.getValue()) {
            throw new DamagedException("block " + number + " does not match its checksum");
        }
        block.limit(size);
        left -= size;
        number++;
    }

    private void read(int bytes) throws IOException {
        block.clear().limit(bytes);
        while (block.hasRemaining()) {
            if (channel.read(block) < 0) {
                throw new DamagedException("the file is truncated in block " + number);
            }
        }
        block.flip();
    }

    /** Checks that nothing is left and that the checksum of the whole holds. */
    void finish() throws IOException {
        if (left > 0 || block.hasRemaining()) {
            throw new DamagedException("there are more numbers than the header says");
        }
        read(Integer.BYTES);
        if (block.getInt(0) != (int) whole.getValue()) {
            throw new DamagedException("the file does not match its checksum");
        }
    }
}
