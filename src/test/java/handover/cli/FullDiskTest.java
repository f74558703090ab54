package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What cannot be written ends with exit code 1 and the name of the file. */
class FullDiskTest {
    private static final String FULL = "/dev/full";

    @TempDir
    Path folder;

    @BeforeEach
    void thereIsOne() {
        assumeTrue(Files.exists(Path.of(FULL)), "only some systems have a disk that is always full");
    }

    private static Output check(String... command) {
        Output o = Output.of(command);
        assertEquals("handover: /dev/full: No space left on device\n", o.err());
        assertEquals(Main.DIFFERENT, o.code());
        return o;
    }

    @Test
    void export() {
        check("export", "bowls-and-spoons", "--keep", "wish", "--out", FULL);
    }

    @Test
    void analyzeReward() {
        check("analyze", "reward", "--objects", "2", "--grid", "4", "--episodes", "2", "--csv", FULL);
    }

    /** Nothing is printed: it shows before any episode is played. */
    @Test
    void analyzeNearest() {
        Path policy = folder.resolve("p.policy");
        Output made = Output.of("precompute", "bowls-and-spoons", "--out", policy.toString(), "--beliefs", "20", "--teacher", "poss:H=1,C=1");
        assertEquals(Main.FINE, made.code(), made.err());
        assertEquals("", check("analyze", "nearest", "--policy", policy.toString(), "--episodes", "2", "--csv", FULL).out());
    }
}
