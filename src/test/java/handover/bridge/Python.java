package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A Python script in a process of its own.
 *
 * @param out file with what it printed, both streams
 */
record Python(Process process, Path out) implements AutoCloseable {
    static final Path SCRIPTS = Path.of("scripts").toAbsolutePath();

    /** Skips the test, and says so, where Python lacks a module. */
    static void assumeModule(String module, String install) throws Exception {
        assume(List.of("python3", "-c", "import sys; assert sys.version_info >= (3, 9); import " + module),
                "python3 with " + module, install);
    }

    static void assumeZmq() throws Exception {
        assumeModule("zmq", "pip install -r scripts/requirements.txt");
    }

    /** Skips the test, and says so, where a command fails. */
    static void assume(List<String> command, String what, String install) throws Exception {
        boolean there = false;
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
            there = process.waitFor(1, TimeUnit.MINUTES) && process.exitValue() == 0;
            process.destroyForcibly();
        } catch (IOException e) {
            there = false;
        }
        if (!there) {
            System.out.println("SKIPPED: needs " + what + ": " + install);
        }
        assumeTrue(there, "needs " + what + ": " + install);
    }

    /** Starts a script of {@code scripts/}. */
    static Python script(Path folder, String name, Object... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(SCRIPTS.resolve(name).toString()));
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        return start(folder, command);
    }

    /** Starts a program that is given as text and finds the scripts' modules. */
    static Python program(Path folder, String code, Object... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("-c", code));
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        return start(folder, command);
    }

    private static Python start(Path folder, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("python3", "-u"));
        command.addAll(arguments);
        Path out = Files.createTempFile(folder, "python", ".out");
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(out.toFile());
        builder.environment().put("PYTHONPATH", SCRIPTS.toString());
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        return new Python(builder.start(), out);
    }

    /** Waits until it has printed something. */
    void untilPrinted(String text) throws Exception {
        for (int tick = 0; !text().contains(text); tick++) {
            assertTrue(tick < 1200 && (process.isAlive() || text().contains(text)), () -> "no \"" + text + "\" in:\n" + text());
            Thread.sleep(50);
        }
    }

    /** Waits for its end, which is to be this one. */
    String ended(int code) throws Exception {
        assertTrue(process.waitFor(2, TimeUnit.MINUTES), () -> "still running:\n" + text());
        assertEquals(code, process.exitValue(), text());
        return text();
    }

    String text() {
        try {
            return Files.readString(out);
        } catch (IOException e) {
            return e.toString();
        }
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
