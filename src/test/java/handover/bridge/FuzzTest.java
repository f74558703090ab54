package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A hundred thousand messages of a seeded generator, good ones among them, to a real bridge; half of them over its stream. */
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
        long version = 1;
        try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", "--source-timeout", "3600");
                WireClient wire = new WireClient(bridge)) {
            String begin = "{\"v\":1,\"type\":\"begin\"}";
            wire.must(begin);
            good.add(begin);
            wire.listen("belief", "error");
            for (int batch = 0; batch < MESSAGES / UNDER_WAY; batch++) {
                List<Fuzzer.Case> cases = new ArrayList<>();
                if (batch % 2 == 1) {
                    good.addAll(streamed(fuzzer, wire, batch, codes));
                    version = good.size();
                    continue;
                }
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
                wire.send(mark(batch));
                wire.reply();
                wire.until(marked(batch));
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

    /** A message that is refused, which tells in the events where a batch ends. */
    private static byte[] mark(int batch) {
        return ("{\"v\":1,\"type\":\"acted\",\"act\":\"DANCE\",\"objects\":[],\"status\":\"started\",\"id\":\"mark" + batch + "\"}")
                .getBytes(StandardCharsets.UTF_8);
    }

    private static Predicate<JsonNode> marked(int batch) {
        return e -> e.path("re").asText().equals("mark" + batch);
    }

    /** Sends a batch over the stream; those that were applied, in this order. Each must have become a belief or an error. */
    private static List<String> streamed(Fuzzer fuzzer, WireClient wire, int batch, Map<String, Integer> codes) throws IOException {
        Map<String, Fuzzer.Case> byId = new HashMap<>();
        Map<String, Integer> nameless = new TreeMap<>();
        for (int k = 0; k < UNDER_WAY; k++) {
            Fuzzer.Case c = fuzzer.intact();
            if (c.id() != null) {
                byId.put(c.id(), c);
            } else if (c.code() != null) {
                nameless.merge(c.code(), 1, Integer::sum);
            }
            if (c.id() == null && k % 7 == 0) {
                wire.push(new byte[0], c.bytes());
                nameless.computeIfPresent(Objects.requireNonNullElse(c.code(), ""), (code, n) -> n - 1);
                nameless.merge("not_json", 1, Integer::sum);
            } else {
                wire.push(c.bytes());
            }
        }
        wire.push(mark(batch));
        List<String> good = new ArrayList<>();
        int told = 0;
        for (JsonNode e = wire.until(x -> true); !marked(batch).test(e); e = wire.until(x -> true)) {
            told++;
            String code = code(e);
            codes.merge(code, 1, Integer::sum);
            Fuzzer.Case c = byId.remove(e.path("re").asText());
            if (c == null) {
                nameless.computeIfPresent(code, (same, n) -> n - 1);
                assertTrue(!code.equals("ok"), e.toString());
            } else {
                check(c, code, e);
                if (code.equals("ok")) {
                    good.add(new String(c.bytes(), StandardCharsets.UTF_8));
                }
            }
        }
        assertEquals(UNDER_WAY, told, "each message is told of once");
        assertEquals(Set.of(), byId.keySet());
        nameless.forEach((code, n) -> assertTrue(n <= 0, n + " missing of " + code));
        return good;
    }

    private static String code(JsonNode reply) {
        return reply.get("type").asText().equals("error") ? reply.get("code").asText() : "ok";
    }

    private static void check(Fuzzer.Case c, String code, JsonNode told) {
        if (c.code() != null) {
            assertEquals(c.code(), code, new String(c.bytes(), StandardCharsets.ISO_8859_1) + " -> " + told);
        }
    }

    /** The code of a reply, checked against what the generator knows of the message. */
    private static String code(Fuzzer.Case c, JsonNode reply) {
        String code = code(reply);
        check(c, code, reply);
        return code;
    }
}
