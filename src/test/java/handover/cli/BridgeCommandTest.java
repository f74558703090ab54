package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The bridge as a process: what it refuses, how it stops, and how it goes on after it was killed. */
class BridgeCommandTest {
    private static final int SIGTERM = 143;

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            bridge                                                    | expected the name or file of a domain; see handover bridge --help
            bridge --resume nolog                                     | nolog: there is no such file
            bridge nowhere                                            | nowhere: there is no such file
            bridge table-line-6 --command tcp://0.0.0.0:*             | --command: tcp://0.0.0.0:* can be reached from other machines
            bridge table-line-6 --stream here                         | --stream: expected tcp://HOST:PORT, got "here"
            bridge table-line-6 --events tcp://127.0.0.1:99999        | --events: expected tcp://HOST:PORT
            bridge table-line-6 --solver clairvoyant                  | --solver: clairvoyant is told what the person wants
            bridge table-line-6 --curve key                           | --curve and --authorized: expected both or neither
            bridge table-line-6 --curve nokey --authorized .          | nokey: expected a file with a key
            bridge table-line-6 --replan 2                            | --replan: expected a total variation distance in [0, 1], got 2.0
            bridge table-line-6 --max-age 0                           | --max-age: expected seconds in (0, 3600], got 0.0
            bridge table-line-6 --queue 0                             | --queue: expected a whole number of at least 1, got 0
            bridge table-line-6 --deadline-ms x                       | --deadline-ms: expected a whole number, got "x"
            bridge table-line-6 --subscribe tcp://127.0.0.1:5800      | --subscribe: expected an adapter
            bridge table-line-6 --resume nolog                        | nolog: there is no such file
            bridge --resume nolog --log pom.xml                       | --log and --resume: expected one of them
            bridge table-line-6 --log pom.xml                         | pom.xml: there is such a file already
            bridge keygen /no/such/folder/key                         | /no/such/folder/key
            """)
    void badInputIsRefused(String command, String problem) {
        Output o = Output.of(command.split(" "));
        assertTrue(o.err().startsWith("handover: " + problem), o.err());
        assertEquals(1, o.err().lines().count(), o.err());
        assertEquals(Main.BAD_INPUT, o.code());
        assertEquals("", o.out());
    }

    @Test
    void keysAreMade() throws IOException {
        Output o = Output.of("bridge", "keygen", folder.resolve("robot").toString());
        assertEquals(Main.FINE, o.code(), o.err());
        String shown = o.out().strip();
        assertTrue(Files.readString(folder.resolve("robot.key")).contains(shown.substring(shown.indexOf(": ") + 2)));
        assertEquals(Main.BAD_INPUT, Output.of("bridge", "keygen", folder.resolve("robot").toString()).code());
    }

    @Test
    void stopsWhenItIsToldToAndGoesOnAfterItWasKilled() throws Exception {
        Path log = folder.resolve("log.jsonl");
        Process first = start("table-line-6", "--log", log.toString());
        try {
            assertEquals(0, ready(first).get("belief_version").asInt());
            first.destroyForcibly();
            assertTrue(first.waitFor(1, TimeUnit.MINUTES));
        } finally {
            first.destroyForcibly();
        }
        Files.writeString(log, Files.readString(log) + "{\"at\":1,\"message\":{\"v\":1,\"type\":\"begin\"},\"belief_version\":1,\"belief\":"
                + "[0.16666666666666666,0.16666666666666666,0.16666666666666666,0.16666666666666666,0.16666666666666666,"
                + "0.16666666666666666],\"human_belief\":[0.16666666666666666,0.16666666666666666,0.16666666666666666,"
                + "0.16666666666666666,0.16666666666666666,0.16666666666666666]}\n{\"at\":2,\"mes");
        Process second = start("--resume", log.toString());
        try {
            JsonNode ready = ready(second);
            assertEquals(1, ready.get("belief_version").asInt());
            assertEquals(log.toString(), ready.get("log").asText());
            Output busy = Output.of("bridge", "--resume", log.toString(), "--command", "tcp://127.0.0.1:*", "--stream",
                    "tcp://127.0.0.1:*", "--events", "tcp://127.0.0.1:*");
            assertEquals("handover: " + log + ": another bridge writes to this log\n", busy.err().substring(busy.err().indexOf('\n') + 1));
            assertEquals(Main.BAD_INPUT, busy.code());
            second.destroy();
            assertTrue(second.waitFor(1, TimeUnit.MINUTES), "it stops");
            assertEquals(SIGTERM, second.exitValue());
        } finally {
            second.destroyForcibly();
        }
        assertEquals(2, Files.readAllLines(log).size(), "the torn line is gone");
        Process third = start("table-line-6", "--resume", log.toString());
        try {
            assertEquals(1, ready(third).get("belief_version").asInt());
        } finally {
            third.destroyForcibly().waitFor();
        }
        assertEquals("1 episodes with 1 messages agree\n", Output.of("replay", log.toString()).out());
        Output other = Output.of("bridge", "table-line-5", "--resume", log.toString());
        assertEquals("handover: " + log + ": is the log of another domain than table-line-5\n", other.err());
        Output seed = Output.of("bridge", "--resume", log.toString(), "--seed", "99");
        assertEquals("handover: --seed: " + log + " began with 1, got 99\n", seed.err());
    }

    /** An address that is taken must not leave an empty log behind. */
    @Test
    void nothingIsLoggedByABridgeThatCannotStart() throws Exception {
        Process first = start("table-line-6", "--log", "none");
        try {
            String taken = ready(first).get("sockets").get("events").asText();
            Path log = folder.resolve("second.jsonl");
            Output o = Output.of("bridge", "table-line-6", "--command", "tcp://127.0.0.1:*", "--stream", "tcp://127.0.0.1:*",
                    "--events", taken, "--log", log.toString());
            assertEquals("handover: --events: cannot bind " + taken + ": it is in use already, or not an address of this machine\n",
                    o.err());
            assertEquals(Main.BAD_INPUT, o.code());
            assertFalse(Files.exists(log));
        } finally {
            first.destroyForcibly().waitFor();
        }
    }

    private Process start(String... more) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "handover.cli.Main", "bridge", "--solver", "confirm"));
        Stream.of("--command", "--stream", "--events").forEach(s -> command.addAll(List.of(s, "tcp://127.0.0.1:*")));
        command.addAll(List.of(more));
        return new ProcessBuilder(command).redirectError(folder.resolve("err").toFile()).start();
    }

    private static JsonNode ready(Process process) throws IOException {
        BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        return new ObjectMapper().readTree(out.readLine());
    }
}
