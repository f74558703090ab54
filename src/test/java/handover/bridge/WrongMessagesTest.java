package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Messages that cannot be used, over both sockets: each gets its code, none moves the belief, the bridge stays up. */
class WrongMessagesTest {
    private static final String DOMAIN = "bowls-and-spoons";
    private static final List<String> GOOD = List.of(
            "{\"v\":1,\"type\":\"begin\"}",
            "{\"v\":1,\"type\":\"speech\",\"text\":\"a silver bowl\"}",
            "{\"v\":1,\"type\":\"acted\",\"act\":\"POINT\",\"objects\":[\"metal_bowl\"],\"status\":\"started\"}",
            "{\"v\":1,\"type\":\"gesture\",\"shoulder\":[0.15,1.4,0.35],\"hand\":[0.05,0.9,0.15]}");

    @TempDir
    Path folder;
    private BridgeProcess bridge;
    private WireClient wire;

    @BeforeEach
    void start() throws Exception {
        bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm");
        wire = new WireClient(bridge);
        for (String message : GOOD) {
            wire.must(message);
        }
    }

    @AfterEach
    void stop() {
        wire.close();
        bridge.close();
    }

    private static Map<String, byte[]> bad() {
        Map<String, byte[]> bad = new LinkedHashMap<>();
        text(bad, "not_json", "hello");
        text(bad, "not_json", "");
        text(bad, "not_json", "[]");
        text(bad, "not_json", "{'v':1,'type':'state'");
        text(bad, "not_json", "[".repeat(100_000));
        text(bad, "not_json", "{'v':1,'type':'state','new':" + "[".repeat(5000) + "]".repeat(5000) + "}");
        bad.put("not_json: invalid UTF-8", new byte[] {'{', '"', 'v', '"', ':', '1', ',', '"', (byte) 0xc3, '(', '"', ':', '1', '}'});
        bad.put("not_json: a broken pair of surrogates", "{\"v\":1,\"type\":\"speech\",\"text\":\"".concat("\u00ed\u00a0\u0080\"}")
                .getBytes(StandardCharsets.ISO_8859_1));
        bad.put("not_json: bytes", new byte[] {0, 1, 2, (byte) 0xff});
        text(bad, "bad_version", "{'v':2,'type':'state'}");
        text(bad, "bad_type", "{'v':1,'type':'sing'}");
        text(bad, "missing_field", "{'v':1}");
        text(bad, "missing_field", "{'v':1,'type':'speech'}");
        text(bad, "missing_field", "{'v':1,'type':'scene','added':[{'name':'a'}]}");
        text(bad, "missing_field", "{'v':1,'type':'gesture','joints':{'left_wrist':[0,1,1],'left_shoulder':null}}");
        text(bad, "bad_field", "{'v':1,'type':'scene','added':[{'name':'a','position':[0,0,0],'words':{'red':1},'colour':'red'}]}");
        text(bad, "bad_field", "{'v':1,'type':'speech','text':'" + "red ".repeat(501) + "'}");
        text(bad, "bad_field", "{'v':1,'type':'speech','alternatives':[{'transcript':'" + "red ".repeat(501) + "','confidence':1}]}");
        text(bad, "bad_field", "{'v':1,'type':'speech','alternatives':["
                + "{'transcript':'red','confidence':0.5},".repeat(100) + "{'transcript':'red','confidence':0.5}]}");
        text(bad, "bad_field", "{'v':1,'type':'gesture','hand':[0,NaN,1],'shoulder':[0,0,1]}");
        text(bad, "bad_field", "{'v':1,'type':'gesture','hand':[0,1e308,1],'shoulder':[0,0,1]}");
        text(bad, "bad_field", "{'v':1,'type':'gesture','hand':[0,1e999,1],'shoulder':[0,0,1]}");
        text(bad, "bad_field", "{'v':1,'type':'gesture','hand':[0,-Infinity,1],'shoulder':[0,0,1]}");
        text(bad, "bad_field", "{'v':1,'type':'gesture','hand':['left',0,1],'shoulder':[0,0,1]}");
        text(bad, "bad_field", "{'v':1,'type':'speech','text':'red','t':1e308}");
        text(bad, "bad_field", "{'v':1,'type':'begin','prior':{'metal_bowl':0.5}}");
        text(bad, "unknown_object", "{'v':1,'type':'acted','act':'ASK','objects':['unicorn'],'status':'started'}");
        text(bad, "unknown_object", "{'v':1,'type':'begin','prior':{'unicorn':1}}");
        text(bad, "unknown_frame", "{'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,0,1],'frame':'moon'}");
        text(bad, "illegal_act", "{'v':1,'type':'acted','act':'JUGGLE','objects':[],'status':'started'}");
        text(bad, "stale", "{'v':1,'type':'speech','text':'blue','t':1000}");
        return bad;
    }

    private static void text(Map<String, byte[]> bad, String code, String json) {
        bad.put(code + ": " + (json.length() < 90 ? json : json.substring(0, 90)), json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void eachGetsItsCodeAndChangesNothing() throws Exception {
        String before = GoodMessages.belief(wire.ask("{'v':1,'type':'state'}"));
        assertEquals(GoodMessages.state(DOMAIN, GOOD), before);
        wire.listen("error");
        for (Map.Entry<String, byte[]> e : bad().entrySet()) {
            wire.send(e.getValue());
            assertCode(e.getKey(), wire.reply());
            assertCode(e.getKey(), wire.until(error -> true));
            wire.push(e.getValue());
            assertCode(e.getKey(), wire.until(error -> true));
        }
        JsonNode after = wire.ask("{'v':1,'type':'state'}");
        assertEquals(before, GoodMessages.belief(after));
        assertEquals(GOOD.size(), after.get("belief_version").asInt());
        assertEquals(2 * bad().size(), after.get("counters").get("errors").asInt(), after.toString());
    }

    @Test
    void tenMegabytesAreTooMuch() throws Exception {
        String before = GoodMessages.belief(wire.ask("{'v':1,'type':'state'}"));
        byte[] large = ("{\"v\":1,\"type\":\"speech\",\"text\":\"" + "red ".repeat(10 << 18) + "\"}").getBytes(StandardCharsets.UTF_8);
        wire.listen("error");
        wire.send(large);
        assertCode("too_large", wire.reply());
        assertCode("too_large", wire.until(e -> true));
        wire.push(large);
        assertCode("too_large", wire.until(e -> true));
        byte[] larger = new byte[40 << 20];
        try (WireClient other = new WireClient(bridge)) {
            other.send(larger);
            other.push(larger);
            Thread.sleep(500);
        }
        assertEquals(before, GoodMessages.belief(wire.ask("{'v':1,'type':'state'}")));
    }

    /** Wrong numbers of frames are answered where there is somebody to answer, and what comes after them is understood. */
    @Test
    void wrongShapesOfMessages() throws Exception {
        String before = GoodMessages.belief(wire.ask("{'v':1,'type':'state'}"));
        byte[] state = "{\"v\":1,\"type\":\"state\"}".getBytes(StandardCharsets.UTF_8);
        byte[] empty = new byte[0];
        wire.listen("error");
        byte[][][] shapes = {{state}, {empty}, {state, state}, {empty, state, state}, {state, empty, state},
            {empty, empty, state}, {empty, empty, empty, empty, empty, empty, empty}};
        for (byte[][] shape : shapes) {
            wire.sendFrames(shape);
            assertCode("not_json", wire.reply());
            assertCode("not_json", wire.until(e -> true));
        }
        for (byte[][] shape : new byte[][][] {{state, state}, {empty, state}, {empty}, {state, empty, state, state}}) {
            wire.push(shape);
            assertCode("not_json", wire.until(e -> true));
        }
        assertEquals(before, GoodMessages.belief(wire.ask("{'v':1,'type':'state'}")));
    }

    private void assertCode(String expected, JsonNode got) throws IOException {
        assertEquals("error", got.get("type").asText(), expected + " -> " + got);
        assertEquals(expected.split(":")[0], got.get("code").asText(), expected + " -> " + got);
        assertTrue(got.get("message").asText().length() > 5, got.toString());
    }
}
