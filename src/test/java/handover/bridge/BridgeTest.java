package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.Messages;
import handover.solver.Confirm;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.zeromq.SocketType;
import org.zeromq.ZMQ;

/** docs/bridge.md over real sockets. */
class BridgeTest {
    @Test
    void anEpisode() {
        try (RunningBridge bridge = RunningBridge.of("table-line-6", new Confirm())) {
            bridge.event("heartbeat");
            JsonNode welcome = bridge.ask("{'v':1,'type':'hello','id':'h'}");
            assertEquals("welcome h table-line-6 base confirm 1", String.join(" ", welcome.get("type").asText(),
                    welcome.get("re").asText(), welcome.get("domain").asText(), welcome.get("variant").asText(),
                    welcome.get("solver").asText(), welcome.get("protocol").asText()));
            assertEquals(DomainFiles.hash(DomainFiles.read("table-line-6")), welcome.get("domain_hash").asText());
            assertEquals(6, welcome.get("objects").size());
            assertEquals("[\"WAIT\",\"PICK\",\"ASK\",\"POINT\",\"LOOK\"]", welcome.get("acts").toString());
            assertEquals(bridge.address("stream"), welcome.get("sockets").get("stream").asText());
            assertEquals("no_episode", bridge.ask("{'v':1,'type':'decide'}").get("code").asText());
            assertEquals("no_episode", bridge.event("error").get("code").asText());

            assertEquals(1, bridge.ask("{'v':1,'type':'begin','prior':{'red_ball':0.6,'blue_ball':0.4}}").get("belief").asInt());
            assertEquals("begin", bridge.event("episode").get("event").asText());
            JsonNode decision = bridge.ask("{'v':1,'type':'decide','id':'d'}");
            assertEquals("ASK red_ball", decision.get("act").asText() + " " + decision.get("objects").get(0).asText());
            assertEquals("red ball", decision.get("say").asText());
            assertEquals("[0.398,0.48,-0.118]", decision.get("target").toString());
            assertEquals(1, decision.get("belief_version").asInt());
            assertFalse(decision.get("fallback").asBoolean());
            assertEquals(decision, bridge.event("decision"));

            String ask = "{'v':1,'type':'acted','act':'ASK','objects':['red_ball'],'status':'%s'}";
            assertEquals(2, bridge.ask(ask.formatted("started")).get("belief").asInt());
            assertEquals("started", bridge.event("act").get("status").asText());
            bridge.push("{'v':1,'type':'speech','source':'mic','text':'yes'}");
            JsonNode belief = bridge.event("belief");
            assertEquals("speech mic 3 yes", belief.get("cause").asText() + " " + belief.get("source").asText() + " "
                    + belief.get("belief_version").asInt() + " " + belief.get("heard").get(0).asText());
            assertTrue(belief.get("belief").get("red_ball").asDouble() > 0.99, belief.toString());
            bridge.ask(ask.formatted("completed"));
            assertEquals("PICK", bridge.ask("{'v':1,'type':'decide'}").get("act").asText());
            bridge.ask("{'v':1,'type':'acted','act':'PICK','objects':['red_ball'],'status':'completed','pick':'accepted'}");
            JsonNode over = bridge.ask("{'v':1,'type':'decide'}");
            assertEquals("WAIT the episode is over", over.get("act").asText() + " " + over.get("note").asText());
            JsonNode state = bridge.ask("{'v':1,'type':'state'}");
            assertEquals("5 1 1 true 5", state.get("belief_version").asInt() + " " + state.get("episode").asInt() + " "
                    + state.get("handovers").asInt() + " " + state.get("done").asBoolean() + " " + state.get("scene").size());
            JsonNode summary = bridge.ask("{'v':1,'type':'end','id':'e1'}");
            assertEquals("summary 2 6", summary.get("type").asText() + " " + summary.get("acts").asInt() + " "
                    + summary.get("belief_version").asInt());
            assertEquals("end", bridge.event("episode").get("event").asText());
            assertEquals(summary, bridge.ask("{'v':1,'type':'end','id':'e1'}"), "asked again by who did not get it");
            assertEquals("no_episode", bridge.ask("{'v':1,'type':'end'}").get("code").asText());
        }
    }

    @Test
    void whatIsSensedTwiceCountsOnce() {
        try (RunningBridge bridge = RunningBridge.of("table-line-6", new Confirm())) {
            bridge.ask("{'v':1,'type':'begin'}");
            String red = "{'v':1,'type':'speech','text':'red','id':'%s','source':'%s'}";
            JsonNode once = bridge.ask(red.formatted("1", "a"));
            assertEquals(once, bridge.ask(red.formatted("1", "a")));
            assertEquals(3, bridge.ask(red.formatted("1", "b")).get("belief").asInt());
            JsonNode unfinal = bridge.ask("{'v':1,'type':'speech','text':'blue','final':false}");
            assertEquals("3 false", unfinal.get("belief").asInt() + " " + unfinal.get("final").asBoolean());
            JsonNode counters = bridge.ask("{'v':1,'type':'state'}").get("counters");
            assertEquals("3 1 1", counters.get("applied") + " " + counters.get("repeated") + " " + counters.get("unfinal"));
        }
    }

    @Test
    void aTableThatChanges() {
        try (RunningBridge bridge = RunningBridge.of("table-line-6", new Confirm())) {
            bridge.event("heartbeat");
            bridge.ask("{'v':1,'type':'begin','prior':{'red_ball':0.5,'blue_ball':0.3,'yellow_block':0.2}}");
            assertEquals("unknown_object", bridge.ask("{'v':1,'type':'scene','removed':['red_ball'],"
                    + "'objects':[{'name':'red_ball','position':[0,0.7,0]}]}").get("code").asText(), "not both at once");
            bridge.ask("{'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,0.7,0]}],'removed':['blue_ball'],"
                    + "'added':[{'name':'cup','position':[0.2,0.7,0],'words':{'blue':1}}]}");
            assertEquals(6, bridge.event("scene").get("objects").size());
            JsonNode state = bridge.ask("{'v':1,'type':'state'}");
            assertEquals(5 / 7.0 * 5 / 6, state.get("belief").get("red_ball").asDouble(), 1e-12);
            assertEquals(1 / 6.0, state.get("belief").get("cup").asDouble(), 1e-12);
            assertEquals("[0.0,0.7,0.0]", state.get("scene").get(1).get("position").toString());
            assertEquals("ASK", bridge.ask("{'v':1,'type':'decide'}").get("act").asText());
            bridge.ask("{'v':1,'type':'end'}");
            bridge.ask("{'v':1,'type':'begin'}");
            assertEquals(1 / 6.0, bridge.ask("{'v':1,'type':'state'}").get("belief").get("cup").asDouble(), 1e-12,
                    "the next episode is on the table as it is now");
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            hello                                                              | not_json       | ``
            {'v':2,'type':'state'}                                             | bad_version    | v
            {'v':1,'type':'sing'}                                              | bad_type       | type
            {'v':1,'type':'speech'}                                            | missing_field  | text
            {'v':1,'type':'gesture','hand':[0,NaN,1],'shoulder':[0,0,1]}       | bad_field      | hand[1]
            {'v':1,'type':'gesture','hand':[0,1e308,1],'shoulder':[0,0,1]}     | bad_field      | hand[1]
            {'v':1,'type':'acted','act':'ASK','objects':['cup'],'status':'started'} | unknown_object | objects[0]
            {'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,0,1],'frame':'camera'} | unknown_frame | frame
            {'v':1,'type':'speech','text':'red','t':1000}                      | stale          | t
            {'v':1,'type':'acted','act':'DANCE','status':'started'}            | illegal_act    | act
            {'v':1,'type':'decide','deadline_ms':-1}                           | bad_field      | deadline_ms
            {'v':1,'type':'scene'}                                             | missing_field  | objects
            {'v':1,'type':'scene','removed':['cup']}                           | unknown_object | removed[0]
            {'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,'x',0]}]} | bad_field | objects[0].position[1]
            {'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,1e9,0]}]} | bad_field | objects[0].position[1]
            {'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,0,0.3]}]} | bad_field | objects[0].position
            {'v':1,'type':'scene','added':[{'name':'cup','position':[0,1,0]}]} | missing_field | added[0].words
            {'v':1,'type':'scene','added':[{'name':'red_ball','position':[0,1,0],'words':{}}]} | bad_field | added[0].name
            {'v':1,'type':'scene','removed':['blue_cylinder','red_ball','purple_marker','blue_ball','yellow_block','green_marker']} | bad_field | removed
            """)
    void badMessagesHaveACodeAndChangeNothing(String message, String code, String path) throws InterruptedException {
        RunningBridge bridge = Shared.BRIDGE;
        JsonNode before = bridge.ask("{'v':1,'type':'state'}");
        JsonNode error = bridge.ask(message);
        assertEquals("error " + code + " " + path, error.get("type").asText() + " " + error.path("code").asText() + " "
                + error.path("path").asText(), error.toString());
        long streamed = before.get("counters").path("streamed").asLong() + 1;
        bridge.push(message);
        JsonNode after = bridge.ask("{'v':1,'type':'state'}");
        while (after.get("counters").path("streamed").asLong() < streamed
                || after.get("counters").get("errors").asLong() < before.get("counters").path("errors").asLong() + 2) {
            Thread.sleep(10);
            after = bridge.ask("{'v':1,'type':'state'}");
        }
        for (String same : List.of("belief", "human_belief", "belief_version", "scene", "open_reference")) {
            assertEquals(before.get(same), after.get(same), same);
        }
    }

    /** One bridge for all messages that change nothing. */
    private static final class Shared {
        static final RunningBridge BRIDGE = RunningBridge.of("table-line-6", new Confirm());

        static {
            BRIDGE.ask("{'v':1,'type':'begin'}");
            BRIDGE.ask("{'v':1,'type':'acted','act':'POINT','objects':['red_ball'],'status':'started'}");
            Runtime.getRuntime().addShutdownHook(new Thread(BRIDGE::stop));
        }
    }

    @Test
    void shapesAndSizes() {
        try (RunningBridge bridge = RunningBridge.of("table-line-6", new Confirm())) {
            bridge.ask("{'v':1,'type':'begin'}");
            ZMQ.Socket dealer = bridge.client(SocketType.DEALER, "command");
            byte[] hello = "{\"v\":1,\"type\":\"hello\"}".getBytes(StandardCharsets.UTF_8);
            for (byte[][] frames : new byte[][][] {{hello}, {hello, hello}, {{}, hello, hello}, {{}}, {{}, {}, hello}}) {
                for (int k = 0; k < frames.length; k++) {
                    dealer.send(frames[k], k < frames.length - 1 ? ZMQ.SNDMORE : 0);
                }
                assertEquals("not_json", answer(dealer).get("code").asText());
            }
            dealer.sendMore(new byte[0]);
            dealer.send(hello);
            assertEquals("welcome", answer(dealer).get("type").asText());
            assertEquals("too_large", bridge.ask(new byte[Messages.LARGEST + 1]).get("code").asText());
            assertEquals("too_large", bridge.ask(new byte[10_000_000]).get("code").asText());
            assertEquals("not_json", bridge.ask(new byte[] {(byte) 0xff, (byte) 0xfe}).get("code").asText());
            assertEquals("not_json", bridge.ask("[".repeat(500_000)).get("code").asText());
            ZMQ.Socket greedy = bridge.client(SocketType.PUSH, "stream");
            greedy.send(new byte[20_000_000]);
            greedy.sendMore("a");
            greedy.send("b");
            assertEquals(1, bridge.ask("{'v':1,'type':'state'}").get("belief_version").asInt());
        }
    }

    private static JsonNode answer(ZMQ.Socket dealer) {
        assertArrayEquals(new byte[0], dealer.recv());
        assertTrue(dealer.hasReceiveMore());
        return RunningBridge.json(dealer.recv());
    }

    @Test
    void heartbeatsAndSilence() {
        HandoverDomain domain = DomainFiles.load("table-line-6");
        BridgeSettings s = RunningBridge.SETTINGS;
        BridgeSettings impatient = new BridgeSettings(s.command(), s.stream(), s.events(), List.of(), Security.LOOPBACK, 1, 100, 0.1,
                new BridgeSettings.Limits(2, 0.5, 10));
        try (RunningBridge bridge = RunningBridge.of(domain, new Confirm(), impatient, Recovery.none(domain, 1, 2), null)) {
            bridge.event("heartbeat");
            bridge.ask("{'v':1,'type':'begin','source':'robot'}");
            bridge.ask("{'v':1,'type':'hello','source':'observer'}");
            bridge.ask("{'v':1,'type':'speech','source':'mic','text':'red'}");
            JsonNode beat = bridge.event("heartbeat");
            assertTrue(beat.get("uptime").asDouble() > 0);
            assertNotNull(beat.get("sources").get("mic").get("last_seen"));
            assertEquals(1, beat.get("sources").size(), "who sensed nothing is no source");
            assertTrue(beat.get("latency_ms").get("apply").get("p99").asDouble() > 0, beat.toString());
            assertEquals(0, beat.get("queues").get("stream").asInt());
            assertEquals("silent silent mic", silence(bridge));
            bridge.event("heartbeat");
            bridge.event("heartbeat");
            bridge.push("{'v':1,'type':'gesture','hand':[0,1,0],'shoulder':[0,0,0],'source':'camera'}");
            assertEquals("silent silent camera", silence(bridge), "the microphone was reported once, the others never");
        }
    }

    private static String silence(RunningBridge bridge) {
        JsonNode e = bridge.event("error");
        return e.get("type").asText() + " " + e.get("code").asText() + " " + e.get("source").asText();
    }
}
