package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A hundred thousand messages of a seeded generator, good ones among them, to a real bridge. */
class FuzzTest {
    private static final int MESSAGES = 100_000;
    private static final int UNDER_WAY = 500;
    private static final String DOMAIN = "table-line-6";

    @TempDir
    Path folder;

    @Test
    void theBeliefIsWhatTheGoodOnesGive() throws Exception {
        Fuzzer fuzzer = new Fuzzer(2026);
        List<String> good = new ArrayList<>();
        Map<String, Integer> codes = new TreeMap<>();
        String last;
        try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm"); WireClient wire = new WireClient(bridge)) {
            String begin = "{\"v\":1,\"type\":\"begin\"}";
            wire.must(begin);
            good.add(begin);
            long version = 1;
            for (int done = 0; done < MESSAGES; done += UNDER_WAY) {
                List<Fuzzer.Case> cases = new ArrayList<>();
                for (int k = 0; k < UNDER_WAY; k++) {
                    cases.add(fuzzer.next());
                    wire.send(cases.get(k).bytes());
                }
                for (Fuzzer.Case c : cases) {
                    JsonNode reply = wire.reply();
                    codes.merge(code(c, reply), 1, Integer::sum);
                    if (reply.path("belief").asLong() > version) {
                        version = reply.get("belief").asLong();
                        good.add(new String(c.bytes(), StandardCharsets.UTF_8).replace('\n', ' '));
                    }
                }
            }
            JsonNode state = wire.must("{\"v\":1,\"type\":\"state\"}");
            last = GoodMessages.belief(state);
            assertEquals(good.size(), state.get("belief_version").asInt(), "each good message counts once");
            assertEquals(version, good.size());
            assertTrue(bridge.isAlive() && !bridge.errors().contains("Exception"), bridge.errors());
        }
        System.out.println("fuzz: " + codes);
        assertTrue(codes.get("ok") > MESSAGES / 10, codes.toString());
        assertEquals(0, codes.getOrDefault("internal", 0), codes.toString());
        assertTrue(codes.size() >= 9, "too few kinds of errors: " + codes);
        assertEquals(GoodMessages.state(DOMAIN, good), last);
    }

    /** The code of a reply, checked against what the generator knows of the message. */
    private static String code(Fuzzer.Case c, JsonNode reply) {
        String type = reply.get("type").asText();
        String code = type.equals("error") ? reply.get("code").asText() : "ok";
        if (c.code() != null) {
            assertEquals(c.code(), code, new String(c.bytes(), StandardCharsets.ISO_8859_1) + " -> " + reply);
        }
        return code;
    }
}
