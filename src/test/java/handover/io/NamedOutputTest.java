package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A full disk is reported with the file that was being written. */
class NamedOutputTest {
    private static final Path FULL = Path.of("/dev/full");

    @TempDir
    Path folder;

    @Test
    void writesWhatItIsGiven() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "something longer that was there before");
        try (BufferedWriter out = NamedOutput.text(file)) {
            out.write("h\u00e9 \u2192 1\n");
        }
        assertEquals("h\u00e9 \u2192 1\n", Files.readString(file));
        Path missing = folder.resolve("no/b.txt");
        assertEquals(missing.toString(), assertThrows(NoSuchFileException.class, () -> NamedOutput.text(missing)).getFile());
    }

    @Test
    void aFullDiskHasAName() throws IOException {
        assumeTrue(Files.exists(FULL), "only some systems have a disk that is always full");
        BufferedWriter out = NamedOutput.text(FULL);
        out.write("a");
        assertEquals("/dev/full: No space left on device", assertThrows(IOException.class, out::flush).getMessage());
        RunHeader header = new RunHeader(DomainFiles.read("bowls-and-spoons"), DomainFiles.read("bowls-and-spoons"), 1,
                List.of("confirm"), 1, 1, 0, null);
        assertEquals("/dev/full: No space left on device",
                assertThrows(IOException.class, () -> EpisodeLogWriter.create(FULL, header)).getMessage());
    }

    /** These are written beside the file that they replace. */
    @Test
    void aFullDiskHasANameForWhatIsReplaced() throws IOException {
        assumeTrue(Files.exists(FULL), "only some systems have a disk that is always full");
        Path file = folder.resolve("b.json");
        Files.createSymbolicLink(folder.resolve("b.json.tmp"), FULL);
        assertEquals(file + ": No space left on device",
                assertThrows(IOException.class, () -> new BenchFile(file).write(Map.of("a", 1))).getMessage());
        Path draft = Files.createSymbolicLink(folder.resolve("c.policy.tmp"), FULL);
        assertEquals(draft + ": No space left on device",
                assertThrows(IOException.class, () -> PolicyFileTest.policy(3, 0).write(folder.resolve("c.policy"))).getMessage());
        Files.delete(draft);
    }
}
