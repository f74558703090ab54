package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.io.SessionLogReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A log that cannot grow for a while, as on a full disk: what is not written is not acknowledged, and the rest stays usable. */
class FullLogTest {
    private static final String SPEECH = "{'v':1,'type':'speech','text':'red','id':'%s','source':'mic'}";

    @TempDir
    Path folder;

    @Test
    void thereIsRoomAgain() throws Exception {
        Path limits = Path.of("/usr/bin/prlimit");
        assumeTrue(Files.exists(limits), "only some systems can limit the files of a process that runs");
        Path log = folder.resolve("log.jsonl");
        JsonNode state;
        int written = 0;
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "confirm", "--log", log.toString());
                WireClient wire = new WireClient(bridge)) {
            wire.must("{'v':1,'type':'begin'}");
            limit(limits, bridge, Files.size(log) + 2000);
            JsonNode reply = wire.ask(SPEECH.formatted(written));
            while (reply.get("type").asText().equals("ok")) {
                reply = wire.ask(SPEECH.formatted(++written));
            }
            assertEquals("internal", reply.get("code").asText(), reply.toString());
            assertTrue(written > 0);
            assertTrue(Files.readString(log).endsWith("}\n"), "no part of the line is left");
            assertEquals("error", wire.ask(SPEECH.formatted(written)).get("type").asText(), "still full");
            limit(limits, bridge, 1L << 40);
            assertEquals(written + 2, wire.must(SPEECH.formatted(written)).get("belief").asInt());
            state = wire.must("{'v':1,'type':'state'}");
            bridge.kill();
        }
        try (SessionLogReader reader = SessionLogReader.open(log)) {
            Recovery recovery = Recovery.of(reader);
            assertEquals(written + 2, recovery.messages());
            assertEquals(state.get("belief").get("red_ball").asDouble(), recovery.session().now().belief().probabilities()[1]);
        }
    }

    private static void limit(Path program, BridgeProcess bridge, long bytes) throws Exception {
        Process process = new ProcessBuilder(program.toString(), "--pid", Long.toString(bridge.pid()), "--fsize=" + bytes + ":").start();
        assertTrue(process.waitFor(30, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue());
    }
}
