package handover.io;

import handover.domain.DomainSpec;
import handover.solver.PolicyPart;
import handover.solver.PolicyTable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/**
 * Policy files: a {@link PolicyTable} with the run that made it. A file is complete or not there: it is written under another
 * name and then moved. Every byte is under a checksum, and nothing is handed out before all of them were compared.
 *
 * @param run what the policy is a function of
 * @param table what was decided
 */
public record PolicyFile(PolicyRun run, PolicyTable table) {

    /** Whether there is a file that begins like a policy file. */
    public static boolean looksLikePolicy(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (var in = Files.newInputStream(file)) {
            return PolicyHead.looksLikePolicy(in.readNBytes(64));
        }
    }

    /** Writes a policy in place of the file, at once. */
    public void write(Path file) throws IOException {
        Path next = file.resolveSibling(file.getFileName() + ".tmp");
        try (BlockOutput out = new BlockOutput(FileChannel.open(next, StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE))) {
            out.raw(PolicyHead.of(run, table).bytes());
            for (PolicyPart p : table.parts()) {
                write(p, out);
            }
            out.finish();
        } catch (IOException e) {
            throw NamedOutput.named(next, e);
        }
        Files.move(next, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void write(PolicyPart p, BlockOutput out) throws IOException {
        int d = 2 * p.part().objects().size();
        for (int r = 0; r < p.size(); r++) {
            out.put(p.coordinates(), r * d, d);
            out.put(p.values(), r * p.acts(), p.acts());
            out.put(p.choices()[r]);
            out.put(p.ordinals()[r]);
        }
    }

    /**
     * Reads a policy for a domain.
     *
     * @throws PolicyFileException if there is no such file, if it is not complete and undamaged, or if it is of another version
     *     or domain
     */
    public static PolicyFile read(Path file, DomainSpec domain) {
        PolicyFile policy = read(file);
        String hash = DomainFiles.hash(domain);
        if (!policy.run.domainHash().equals(hash)) {
            throw new PolicyFileException(file, "is a policy for the domain " + policy.run.domain() + " (" + policy.run.domainHash()
                    + "), not for " + domain.name() + " (" + hash + ")");
        }
        return policy;
    }

    /** Reads a policy for whatever domain; throws as {@link #read(Path, DomainSpec)}. */
    public static PolicyFile read(Path file) {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            PolicyHead.Read start = PolicyHead.read(channel, file);
            BlockInput in = new BlockInput(channel, start.raw(), start.head().bodyBytes());
            List<PolicyPart> parts = new ArrayList<>();
            for (PolicyHead.Part p : start.head().parts()) {
                parts.add(read(p, in));
            }
            in.finish();
            return new PolicyFile(start.head().run(), new PolicyTable(start.head().run().beliefMetric(), parts));
        } catch (BlockInput.DamagedException e) {
            throw new PolicyFileException(file, "is damaged: " + e.getMessage(), e);
        } catch (NoSuchFileException e) {
            throw new PolicyFileException(file, "there is no such file", e);
        } catch (IOException e) {
            throw new PolicyFileException(file, "cannot be read: " + e.getMessage(), e);
        }
    }

    private static PolicyPart read(PolicyHead.Part p, BlockInput in) throws IOException {
        int d = 2 * p.key().objects().size();
        int n = p.beliefs();
        float[] coordinates = new float[n * d];
        float[] values = new float[n * p.acts()];
        int[] choices = new int[n];
        int[] ordinals = new int[n];
        for (int r = 0; r < n; r++) {
            in.next(coordinates, r * d, d);
            in.next(values, r * p.acts(), p.acts());
            choices[r] = in.next();
            ordinals[r] = in.next();
        }
        return new PolicyPart(p.key(), p.acts(), coordinates, values, choices, ordinals);
    }
}
