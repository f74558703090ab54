package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.solver.BeliefPart;
import handover.solver.PolicyTable;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.CRC32C;

/**
 * The readable beginning of a policy file: a line with format, version, and length and checksum of what follows, then JSON that
 * says which run this is and which parts the body has, in its order.
 *
 * @param run what the policy is a function of
 * @param parts of the table
 */
record PolicyHead(PolicyRun run, List<Part> parts) {
    static final int VERSION = 1;
    private static final String FORMAT = "handover-policy";
    private static final Pattern FIRST_LINE = Pattern.compile(FORMAT + " ([0-9]{1,9}) ([0-9]{1,9}) ([0-9a-f]{8})\n");
    private static final int LONGEST_LINE = FORMAT.length() + 32;
    private static final String RECORD = "little-endian, for each belief: 2n float32 coordinates (sqrt(b_i/2), then "
            + "sqrt(w h_i/2)), float32 value of each act (NaN: none), int32 index of the act chosen, int32 position in the "
            + "order of sampling; blocks of 1 MiB, each followed by its CRC-32C; CRC-32C of the whole file";

    /**
     * One part of the body.
     *
     * @param key which
     * @param acts values of each belief
     * @param beliefs how many
     */
    record Part(BeliefPart key, int acts, int beliefs) {
        /** Bytes of one record. */
        long recordBytes() {
            return 4L * (2L * key.objects().size() + acts + 2);
        }
    }

    static PolicyHead of(PolicyRun run, PolicyTable table) {
        return new PolicyHead(run, table.parts().stream().map(p -> new Part(p.part(), p.acts(), p.size())).toList());
    }

    /** Bytes of numbers in the body. */
    long bodyBytes() {
        return parts.stream().mapToLong(p -> p.recordBytes() * p.beliefs).sum();
    }

    byte[] bytes() {
        String list = parts.stream().map(p -> Json.line(RecordMapper.tree(p))).collect(Collectors.joining(",\n"));
        String text = "{\"run\": " + Json.line(run.json()) + ",\n\"record\": \"" + RECORD + "\",\n\"parts\": [\n" + list + "]}\n";
        byte[] json = text.getBytes(StandardCharsets.UTF_8);
        String first = String.format(Locale.ROOT, "%s %d %d %08x\n", FORMAT, VERSION, json.length, crc(json));
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(first.getBytes(StandardCharsets.US_ASCII));
        all.writeBytes(json);
        return all.toByteArray();
    }

    /** Whether a file begins like a policy file of any version. */
    static boolean looksLikePolicy(byte[] beginning) {
        return new String(beginning, StandardCharsets.ISO_8859_1).startsWith(FORMAT + " ");
    }

    /**
     * Reads a head; the channel is then at the first block.
     *
     * @return the head's bytes in {@code raw}
     * @throws PolicyFileException for anything but the head of a policy file of this version
     */
    static Read read(FileChannel channel, Path file) throws IOException {
        byte[] beginning = bytes(channel, 0, (int) Math.min(LONGEST_LINE, channel.size()));
        String text = new String(beginning, StandardCharsets.ISO_8859_1);
        Matcher line = FIRST_LINE.matcher(text);
        if (!line.lookingAt()) {
            throw new PolicyFileException(file, looksLikePolicy(beginning) ? "the first line of this policy file is damaged"
                    : "is not a policy file; handover precompute makes one");
        }
        int version = Integer.parseInt(line.group(1));
        if (version != VERSION) {
            throw new PolicyFileException(file, "is a policy file of version " + version
                    + "; this program reads version " + VERSION + ". Make it again with handover precompute");
        }
        int length = Integer.parseInt(line.group(2));
        if (line.end() + (long) length > channel.size()) {
            throw new PolicyFileException(file, "is truncated: the header alone has " + length + " bytes");
        }
        byte[] json = bytes(channel, line.end(), length);
        if (crc(json) != Integer.parseUnsignedInt(line.group(3), 16)) {
            throw new PolicyFileException(file, "is damaged: the header does not match its checksum");
        }
        channel.position(line.end() + (long) length);
        return new Read(parse(json, file), bytes(channel, 0, line.end() + length));
    }

    /**
     * A head as it was read.
     *
     * @param raw all its bytes
     */
    record Read(PolicyHead head, byte[] raw) {}

    private static PolicyHead parse(byte[] json, Path file) {
        JsonNode tree = JsonText.parse(json, file.toString());
        List<Part> parts = new ArrayList<>();
        for (JsonNode p : tree.path("parts")) {
            parts.add(RecordMapper.bind(p, Part.class, Place.of(file.toString())));
        }
        return new PolicyHead(PolicyRun.of(tree.path("run"), file.toString()), parts);
    }

    private static byte[] bytes(FileChannel channel, long from, int count) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(count);
        while (buffer.hasRemaining() && channel.read(buffer, from + buffer.position()) >= 0) {
            continue;
        }
        return buffer.array();
    }

    private static int crc(byte[] bytes) {
        CRC32C crc = new CRC32C();
        crc.update(bytes);
        return (int) crc.getValue();
    }
}
