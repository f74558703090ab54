package handover.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A precompute in a process of its own, killed twenty times. */
class KilledTest {
    private static final int KILLS = 20;
    /** Enough to outlive the kills. */
    private static final String[] RUN = {"precompute", "bowls-and-spoons", "--teacher", "poss:H=2,C=2", "--beliefs", "20000"};

    @TempDir
    Path folder;

    @Test
    void whatWasKilledTwentyTimesIsTheSame() throws Exception {
        Path whole = folder.resolve("whole");
        assertEquals(0, start(whole, 2).waitFor());
        Path killed = folder.resolve("killed");
        Path partial = folder.resolve("killed.partial");
        SplittableRandom random = new SplittableRandom(5);
        long most = 0;
        int grew = 0;
        for (int k = 0; k < KILLS; k++) {
            Process process = start(killed, 1 + k % 3);
            long before = most;
            // Half of the kills come at a random time, half soon after the file has grown.
            for (int tick = 0; k % 2 == 1 && size(partial) <= before && tick < 5000; tick++) {
                Thread.sleep(1);
            }
            Thread.sleep(random.nextInt(k % 2 == 1 ? 50 : 700));
            process.destroyForcibly();
            assertTrue(process.waitFor(10, TimeUnit.SECONDS));
            assertEquals(128 + 9, process.exitValue(), "killed, not finished");
            most = size(partial);
            grew += most > before ? 1 : 0;
        }
        assertTrue(grew >= KILLS / 4, "only " + grew + " of the kills came after some work");
        assertFalse(Files.exists(killed));
        assertEquals(0, start(killed, 2).waitFor());
        assertArrayEquals(Files.readAllBytes(whole), Files.readAllBytes(killed));
        assertFalse(Files.exists(partial));
    }

    private static long size(Path file) throws IOException {
        return Files.exists(file) ? Files.size(file) : 0;
    }

    private Process start(Path out, int threads) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xshare:auto",
                "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", System.getProperty("java.class.path"), "handover.cli.Main"));
        command.addAll(List.of(RUN));
        command.addAll(List.of("--threads", String.valueOf(threads), "--out", out.toString()));
        return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile()).start();
    }
}
