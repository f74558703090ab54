package handover.io;

import handover.solver.BeliefPart;
import handover.solver.StoredBelief;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.zip.CRC32C;

/**
 * The solved beliefs of a precompute under way: a line that says which run, then one entry for each unit of work, in order,
 * each with length and checksum. An entry that is torn or damaged is cut off with all that follows it, and made again: every
 * unit is a function of the run and its number, so that the result is the same. Used by one thread at a time; a second process
 * is refused.
 */
public final class PointJournal implements Closeable {
    private static final String FORMAT = "handover-points 1 ";
    private static final int LARGEST = 1 << 28;

    private final Path file;
    private final FileChannel channel;
    private int units;

    private PointJournal(Path file, FileChannel channel) {
        this.file = file;
        this.channel = channel;
    }

    /**
     * Opens or begins the journal of a run.
     *
     * @param unit is given the beliefs of each unit that is finished, in order
     * @throws PolicyFileException if the file is there and is not the journal of this run, or if somebody else is writing it
     */
    public static PointJournal open(Path file, PolicyRun run, Consumer<List<StoredBelief>> unit) throws IOException {
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            lock(channel, file);
            PointJournal journal = new PointJournal(file, channel);
            byte[] header = (FORMAT + Json.line(run.json()) + "\n").getBytes(StandardCharsets.UTF_8);
            journal.begin(header, run);
            journal.replay(header.length, unit);
            return journal;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    private static void lock(FileChannel channel, Path file) throws IOException {
        try {
            FileLock lock = channel.tryLock();
            if (lock == null) {
                throw new PolicyFileException(file, "another process is writing this file");
            }
        } catch (OverlappingFileLockException e) {
            throw new PolicyFileException(file, "this file is being written", e);
        }
    }

    private void begin(byte[] header, PolicyRun run) throws IOException {
        byte[] there = read(0, (int) Math.min(header.length, channel.size()));
        if (there.length < header.length && Arrays.equals(there, Arrays.copyOf(header, there.length))) {
            channel.truncate(0);
            append(header);
        } else if (!Arrays.equals(there, header)) {
            throw new PolicyFileException(file, "is not the unfinished policy of this run" + different(run)
                    + "; finish that run, delete the file, or choose another --out");
        }
    }

    private String different(PolicyRun run) throws IOException {
        String text = new String(read(0, (int) Math.min(1 << 16, channel.size())), StandardCharsets.UTF_8);
        int end = text.indexOf('\n');
        if (!text.startsWith(FORMAT) || end < 0) {
            return "";
        }
        PolicyRun other = PolicyRun.of(JsonText.parse(text.substring(FORMAT.length(), end).getBytes(StandardCharsets.UTF_8),
                file.toString()), file.toString());
        return " (" + other.differences(run) + ")";
    }

    private void replay(long from, Consumer<List<StoredBelief>> unit) throws IOException {
        long at = from;
        for (byte[] entry = entry(at); entry != null; entry = entry(at)) {
            unit.accept(decode(entry));
            units++;
            at += 2 * Integer.BYTES + entry.length;
        }
        channel.truncate(at);
        channel.position(at);
    }

    /** The entry at a position; null if there is no whole one. */
    private byte[] entry(long at) throws IOException {
        int head = 2 * Integer.BYTES;
        if (at + head > channel.size()) {
            return null;
        }
        ByteBuffer start = ByteBuffer.wrap(read(at, head));
        int length = start.getInt();
        if (length < 0 || length > LARGEST || at + head + length > channel.size()) {
            return null;
        }
        byte[] entry = read(at + head, length);
        return crc(entry) == start.getInt() ? entry : null;
    }

    /** Units that are finished. */
    public int units() {
        return units;
    }

    /** Adds the beliefs of the next unit. Throws {@link UncheckedIOException} if that fails. */
    public void add(List<StoredBelief> beliefs) {
        try {
            byte[] entry = encode(beliefs);
            append(ByteBuffer.allocate(2 * Integer.BYTES + entry.length).putInt(entry.length).putInt(crc(entry)).put(entry).array());
            units++;
        } catch (IOException e) {
            throw new UncheckedIOException(NamedOutput.named(file, e));
        }
    }

    private static byte[] encode(List<StoredBelief> beliefs) throws IOException {
        Map<BeliefPart, Integer> parts = new LinkedHashMap<>();
        beliefs.forEach(b -> parts.putIfAbsent(b.part(), parts.size()));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeInt(parts.size());
        for (BeliefPart p : parts.keySet()) {
            byte[] json = Json.line(RecordMapper.tree(p)).getBytes(StandardCharsets.UTF_8);
            out.writeInt(json.length);
            out.write(json);
        }
        out.writeInt(beliefs.size());
        for (StoredBelief b : beliefs) {
            out.writeInt(parts.get(b.part()));
            write(b.coordinates(), out);
            write(b.values(), out);
            out.writeInt(b.act());
        }
        return bytes.toByteArray();
    }

    private List<StoredBelief> decode(byte[] entry) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(entry));
        List<BeliefPart> parts = new ArrayList<>();
        for (int k = in.readInt(); k > 0; k--) {
            byte[] json = in.readNBytes(in.readInt());
            parts.add(RecordMapper.bind(JsonText.parse(json, file.toString()), BeliefPart.class, Place.of(file.toString())));
        }
        List<StoredBelief> beliefs = new ArrayList<>();
        for (int k = in.readInt(); k > 0; k--) {
            beliefs.add(new StoredBelief(parts.get(in.readInt()), floats(in), floats(in), in.readInt()));
        }
        return beliefs;
    }

    private static void write(float[] values, DataOutputStream out) throws IOException {
        out.writeInt(values.length);
        for (float v : values) {
            out.writeFloat(v);
        }
    }

    private static float[] floats(DataInputStream in) throws IOException {
        float[] values = new float[in.readInt()];
        for (int k = 0; k < values.length; k++) {
            values[k] = in.readFloat();
        }
        return values;
    }

    private byte[] read(long from, int count) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(count);
        while (buffer.hasRemaining() && channel.read(buffer, from + buffer.position()) >= 0) {
            continue;
        }
        return buffer.array();
    }

    private void append(byte[] bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        while (buffer.hasRemaining()) {
            channel.write(buffer);
        }
    }

    private static int crc(byte[] bytes) {
        CRC32C crc = new CRC32C();
        crc.update(bytes);
        return (int) crc.getValue();
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
