package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A bridge that is killed goes on from its log; one that is told to stop does so soon and loses nothing. */
class SurvivalTest {
    private static final String DOMAIN = "bowls-and-spoons";
    private static final String STATE = "{'v':1,'type':'state'}";
    private static final int KILLS = 4;
    /** The bridge is to stop within 2 s; a machine that does other things too may take longer. */
    private static final long STOPS_WITHIN_MS = 10_000;

    @TempDir
    Path folder;

    @Test
    void aKilledBridgeGoesOnWithTheSameBeliefs() throws Exception {
        Path log = folder.resolve("session.jsonl");
        SplittableRandom chance = new SplittableRandom(11);
        List<String> acknowledged = new ArrayList<>();
        String option = "--log";
        for (int life = 0; life <= KILLS; life++) {
            try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", option, log.toString());
                    WireClient wire = new WireClient(bridge)) {
                if (life > 0) {
                    JsonNode state = wire.must(STATE);
                    assertEquals(acknowledged.size(), state.get("belief_version").asInt());
                    assertEquals(GoodMessages.state(DOMAIN, acknowledged), GoodMessages.belief(state));
                }
                for (int k = 0; k < 50; k++) {
                    String message = message(life, k, chance);
                    wire.must(message);
                    acknowledged.add(message);
                }
                bridge.kill();
            }
            if (life % 2 == 0) {
                Files.writeString(log, "{\"at\":1.5,\"message\":{\"v\":1,\"ty", StandardOpenOption.APPEND);
            }
            option = "--resume";
        }
    }

    /** Nobody knows how much of the stream a killed bridge has seen, but what it wrote down is what it goes on with. */
    @Test
    void killedUnderLoadItGoesOnWhereItsLogEnds() throws Exception {
        Path log = folder.resolve("session.jsonl");
        List<String> sent = new ArrayList<>();
        sent.add("{\"v\":1,\"type\":\"begin\"}");
        SplittableRandom chance = new SplittableRandom(12);
        for (int k = 1; k < 3000; k++) {
            sent.add(message(1, k, chance));
        }
        try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", "--queue", "100000", "--log", log.toString());
                WireClient wire = new WireClient(bridge)) {
            wire.must(sent.get(0));
            wire.listen("belief");
            sent.subList(1, sent.size()).forEach(m -> wire.push(m.getBytes(StandardCharsets.UTF_8)));
            wire.until(e -> e.get("belief_version").asInt() > 20);
            bridge.kill();
        }
        try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", "--resume", log.toString());
                WireClient wire = new WireClient(bridge)) {
            JsonNode state = wire.must(STATE);
            int version = state.get("belief_version").asInt();
            assertTrue(version > 20, state.toString());
            assertEquals(GoodMessages.state(DOMAIN, sent.subList(0, version)), GoodMessages.belief(state));
            assertEquals("ok", wire.ask("{'v':1,'type':'speech','text':'silver'}").get("type").asText());
        }
    }

    @Test
    void toldToStopItStopsSoonAndEveryAnswerIsInItsLog() throws Exception {
        Path log = folder.resolve("session.jsonl");
        SplittableRandom chance = new SplittableRandom(13);
        try (BridgeProcess bridge = BridgeProcess.start(folder, "kitchen-20", "--solver", "poss:H=6,C=50", "--log", log.toString());
                WireClient wire = new WireClient(bridge)) {
            wire.must("{'v':1,'type':'begin','id':'b'}");
            int version = 1;
            for (int k = 0; k < 200; k++) {
                version = wire.must("{'v':1,'type':'speech','text':'" + (chance.nextBoolean() ? "red" : "cup") + "','id':'s" + k + "'}")
                        .get("belief").asInt();
            }
            wire.send("{\"v\":1,\"type\":\"decide\",\"deadline_ms\":60000,\"id\":\"d\"}".getBytes(StandardCharsets.UTF_8));
            wire.must("{'v':1,'type':'hello'}"); // so that it has what was sent before
            long start = System.nanoTime();
            int code = bridge.terminate();
            long took = (System.nanoTime() - start) / 1_000_000;
            System.out.println("the bridge stopped in " + took + " ms");
            assertTrue(code == 0 || code == 128 + 15, "exit code " + code + ": " + bridge.errors());
            assertTrue(took < STOPS_WITHIN_MS, took + " ms");
            JsonNode unmade = wire.reply();
            assertEquals("d busy", unmade.get("re").asText() + " " + unmade.path("code").asText(), unmade.toString());
            List<JsonNode> applied = new ArrayList<>();
            for (String line : Files.readAllLines(log)) {
                JsonNode entry = BridgeProcess.JSON.readTree(line);
                if (entry.has("message")) {
                    applied.add(entry);
                }
            }
            assertEquals(version, applied.size());
            assertEquals(version, applied.get(applied.size() - 1).get("belief_version").asInt());
            assertTrue(Files.readString(log).endsWith("\n"));
        }
    }

    private static String message(int life, int k, SplittableRandom chance) {
        String id = "\"id\":\"" + life + "-" + k + "\",\"source\":\"all\"";
        if (k == 0 && life == 0) {
            return "{\"v\":1,\"type\":\"begin\"," + id + "}";
        }
        return switch (chance.nextInt(4)) {
            case 0 -> "{\"v\":1,\"type\":\"speech\",\"text\":\"silver bowl\"," + id + "}";
            case 1 -> "{\"v\":1,\"type\":\"gesture\",\"shoulder\":[0.15,1.4,0.35],\"hand\":[" + chance.nextDouble() + ",0.9,0.1]," + id + "}";
            case 2 -> "{\"v\":1,\"type\":\"acted\",\"act\":\"ASK\",\"objects\":[\"silver_spoon\"],\"status\":\"started\"," + id + "}";
            default -> "{\"v\":1,\"type\":\"speech\",\"text\":\"no, not the spoon\"," + id + "}";
        };
    }
}
