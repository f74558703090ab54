package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** A real bridge in a process of its own, on ports that are free. */
final class BridgeProcess implements AutoCloseable {
    static final ObjectMapper JSON = new ObjectMapper();
    private static final String ANY = "tcp://127.0.0.1:*";
    private static final int PATIENCE_S = 60;

    private final Process process;
    private final Path errors;
    private final JsonNode ready;

    private BridgeProcess(Process process, Path errors, JsonNode ready) {
        this.process = process;
        this.errors = errors;
        this.ready = ready;
    }

    /** @param arguments the domain and options; addresses are added */
    static BridgeProcess start(Path folder, String... arguments) throws Exception {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", System.getProperty("java.class.path"),
                "handover.cli.Main", "bridge"));
        command.addAll(List.of(arguments));
        command.addAll(List.of("--command", ANY, "--stream", ANY, "--events", ANY));
        Path errors = Files.createTempFile(folder, "bridge", ".err");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors.toFile()).start();
        BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        try {
            String line = CompletableFuture.supplyAsync(() -> line(out)).get(PATIENCE_S, TimeUnit.SECONDS);
            assertNotNull(line, () -> "the bridge did not start: " + read(errors));
            return new BridgeProcess(process, errors, JSON.readTree(line));
        } catch (Exception | AssertionError e) {
            process.destroyForcibly();
            throw e;
        }
    }

    private static String line(BufferedReader out) {
        try {
            return out.readLine();
        } catch (IOException e) {
            return null;
        }
    }

    /** What it said when it was ready. */
    JsonNode ready() {
        return ready;
    }

    /** Address of a socket: command, stream or events. */
    String address(String socket) {
        return ready.get("sockets").get(socket).textValue();
    }

    int port(String socket) {
        String address = address(socket);
        return Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
    }

    long pid() {
        return process.pid();
    }

    boolean isAlive() {
        return process.isAlive();
    }

    String errors() {
        return read(errors);
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            return e.toString();
        }
    }

    /** kill -9. */
    void kill() throws InterruptedException {
        process.destroyForcibly();
        assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
    }

    /** SIGTERM; the exit code. */
    int terminate() throws InterruptedException {
        process.destroy();
        assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "still running");
        return process.exitValue();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
