package handover.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.math.Simplex;
import handover.solver.BeliefMetric;
import handover.solver.BeliefSpace;
import handover.solver.Decision;
import handover.solver.PolicyTable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is read is what was written, or nothing. */
class PolicyFileTest {
    private static final int FIRST_LINE = 32;
    private static final DomainSpec SPEC = DomainFiles.read("bowls-and-spoons");

    @TempDir
    Path folder;

    @Test
    void whatIsWrittenIsRead() throws IOException {
        PolicyFile policy = policy(300, 0);
        Path file = folder.resolve("a.policy");
        policy.write(file);
        PolicyFile read = PolicyFile.read(file, SPEC);
        assertEquals(policy.run(), read.run());
        Path again = folder.resolve("b.policy");
        read.write(again);
        assertArrayEquals(Files.readAllBytes(file), Files.readAllBytes(again));
        assertEquals(List.of(file, again), Files.list(folder).sorted().toList(), "nothing else is left");
    }

    /** More than one block, with a record across the boundary. */
    @Test
    void manyBlocks() throws IOException {
        Path file = folder.resolve("a.policy");
        policy(25_000, 0).write(file);
        byte[] bytes = Files.readAllBytes(file);
        assertTrue(bytes.length > 2 * BlockOutput.BLOCK);
        assertEquals(25_000, PolicyFile.read(file).table().size());
        bytes[BlockOutput.BLOCK + 12345] ^= 16;
        assertTrue(damage(file, bytes).contains("is damaged: block 1 does not match its checksum"), damage(file, bytes));
    }

    @Test
    void theHeaderCanBeRead() throws IOException {
        Path file = folder.resolve("a.policy");
        policy(3, 0).write(file);
        List<String> lines = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).lines().limit(2).toList();
        assertTrue(lines.get(0).matches("handover-policy 1 \\d+ [0-9a-f]{8}"), lines.get(0));
        assertTrue(lines.get(1).contains("\"domain\":\"bowls-and-spoons\",\"domain_hash\":\"" + DomainFiles.hash(SPEC)
                + "\",\"teacher\":\"poss:H=1,C=1\""), lines.get(1));
    }

    /** At every length, and with a bit flipped in every byte (in the first line every bit): refused, with the file's name. */
    @Test
    void truncatedOrDamagedFilesAreNeverUsed() throws IOException {
        Path file = folder.resolve("a.policy");
        policy(4, 0).write(file);
        byte[] bytes = Files.readAllBytes(file);
        for (int length = 0; length < bytes.length; length++) {
            assertTrue(damage(file, Arrays.copyOf(bytes, length)).startsWith(file + ": "));
        }
        assertTrue(damage(file, Arrays.copyOf(bytes, bytes.length + 1)).contains("expected " + bytes.length + " bytes"));
        for (int bit = 0; bit < 8 * bytes.length; bit += bit < 8 * FIRST_LINE ? 1 : 9) {
            byte[] flipped = bytes.clone();
            flipped[bit / 8] ^= (byte) (1 << bit % 8);
            assertTrue(damage(file, flipped).startsWith(file + ": "), "bit " + bit);
        }
    }

    private static String damage(Path file, byte[] bytes) throws IOException {
        Files.write(file, bytes);
        return assertThrows(PolicyFileException.class, () -> PolicyFile.read(file)).getMessage();
    }

    @Test
    void anotherDomainIsRefusedWithBothNames() throws IOException {
        Path file = folder.resolve("a.policy");
        policy(4, 0).write(file);
        DomainSpec six = DomainFiles.read("table-line-6");
        assertEquals(file + ": is a policy for the domain bowls-and-spoons (" + DomainFiles.hash(SPEC) + "), not for table-line-6 ("
                + DomainFiles.hash(six) + ")", assertThrows(PolicyFileException.class, () -> PolicyFile.read(file, six)).getMessage());
        DomainSpec other = SPEC.with(s -> s.tau = 0.9);
        assertThrows(PolicyFileException.class, () -> PolicyFile.read(file, other));
    }

    @Test
    void anotherVersionIsRefusedWithBothNumbers() throws IOException {
        Path file = folder.resolve("a.policy");
        policy(4, 0).write(file);
        String text = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        byte[] next = text.replaceFirst("handover-policy 1 ", "handover-policy 2 ").getBytes(StandardCharsets.ISO_8859_1);
        assertTrue(damage(file, next).contains("is a policy file of version 2; this program reads version 1."));
        assertTrue(damage(file, "{\"format\": \"mine\"}\n".getBytes(StandardCharsets.UTF_8)).contains("is not a policy file"));
        assertFalse(PolicyFile.looksLikePolicy(file));
        Path nothing = folder.resolve("nothing");
        assertEquals(nothing + ": there is no such file",
                assertThrows(PolicyFileException.class, () -> PolicyFile.read(nothing)).getMessage());
    }

    /** A policy with so many beliefs at random, in two parts. */
    static PolicyFile policy(int beliefs, long seed) {
        HandoverDomain domain = DomainFiles.domain(SPEC);
        BeliefSpace space = new BeliefSpace(BeliefMetric.DEFAULT);
        PolicyTable.Builder builder = new PolicyTable.Builder(BeliefMetric.DEFAULT, beliefs);
        SplittableRandom random = new SplittableRandom(seed);
        while (builder.size() < beliefs) {
            HandoverBelief belief = HandoverBelief.of(domain.task(domain.start()), distribution(random), distribution(random));
            if (random.nextBoolean()) {
                belief = belief.after(Act.of("ASK", "metal_bowl"));
            }
            builder.add(space.stored(belief, new Decision(Act.WAIT, Map.of(Act.WAIT, random.nextDouble()), 1, 1, true)));
        }
        return new PolicyFile(PolicyRun.of(SPEC, "poss:H=1,C=1", 0, beliefs, seed, List.of()), builder.build());
    }

    private static double[] distribution(SplittableRandom random) {
        double[] p = random.doubles(4).toArray();
        Simplex.normalise(p, 4);
        return p;
    }
}
