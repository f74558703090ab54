package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The scripts' own tests, which are Python's. */
class PythonTest {
    @TempDir
    Path folder;

    @Test
    void theScriptsKnowTheTopics() throws Exception {
        Python.assumeZmq();
        try (Python python = Python.program(folder, "import client; print(*client.TOPICS)")) {
            assertEquals(String.join(" ", Topics.ALL) + "\n", python.ended(0));
        }
    }

    @Test
    void theScriptsOwnTestsPass() throws Exception {
        Python.assumeZmq();
        Path out = folder.resolve("out");
        ProcessBuilder builder = new ProcessBuilder("python3", "-m", "unittest", "discover", "-v", "-s", "tests");
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        Process process = builder.directory(Python.SCRIPTS.toFile()).redirectErrorStream(true).redirectOutput(out.toFile()).start();
        try {
            assertTrue(process.waitFor(5, TimeUnit.MINUTES), "still running");
            assertEquals(0, process.exitValue(), Files.readString(out));
        } finally {
            process.destroyForcibly();
        }
        Files.readAllLines(out).stream().filter(l -> l.contains("skipped")).forEach(l -> System.out.println("SKIPPED: " + l));
    }
}
