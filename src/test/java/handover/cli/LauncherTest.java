package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code scripts/handover}, with a program in Java's place that tells how it was started. */
class LauncherTest {
    private static final String INSTEAD_OF_JAVA = "#!/bin/sh\necho \"$@\"\nchrt -p $$ 2>/dev/null\nexit 3\n";

    @TempDir
    Path home;

    @BeforeEach
    void onlyWhereThereAreShells() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no /bin/sh");
        Path java = Files.createDirectories(home.resolve("bin")).resolve("java");
        Files.writeString(java, INSTEAD_OF_JAVA);
        assumeTrue(java.toFile().setExecutable(true), "no executable files");
    }

    @Test
    void argumentsAndExitCodeComeThrough() throws Exception {
        assertTrue(run("simulate", "--domain", "two words").startsWith("-Xmx1g -jar /some.jar simulate --domain two words\n"));
    }

    /** The policy keeps the I/O thread from displacing who wakes it; other commands have no such thread. */
    @Test
    void onlyABridgeIsStartedAsBatch() throws Exception {
        assumeTrue(isBatchPossible(), "no chrt, or it may not set the batch policy");
        assertTrue(run("bridge", "table-line-6").contains("SCHED_BATCH"));
        assertTrue(run("simulate").contains("SCHED_OTHER"));
    }

    private static boolean isBatchPossible() throws InterruptedException {
        try {
            return new ProcessBuilder("chrt", "--batch", "0", "true").start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    private String run(String... args) throws Exception {
        List<String> command = new ArrayList<>(List.of("/bin/sh", "scripts/handover"));
        command.addAll(List.of(args));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("JAVA_HOME", home.toString());
        builder.environment().put("HANDOVER_JAR", "/some.jar");
        builder.environment().put("JAVA_OPTS", "-Xmx1g");
        Process process = builder.start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(process.waitFor(1, TimeUnit.MINUTES), "still running");
        assertEquals(3, process.exitValue(), out);
        return out;
    }
}
