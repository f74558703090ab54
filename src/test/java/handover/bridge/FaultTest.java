package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Clients that die, hang, repeat themselves or have wrong clocks: the bridge serves the others as if nothing had been. */
class FaultTest {
    private static final String DOMAIN = "bowls-and-spoons";
    private static final String STATE = "{'v':1,'type':'state'}";
    private static final int CONNECTIONS = 1000;

    @TempDir
    Path folder;

    @Test
    void sensorsKilledInTheMiddleOfAMessage() throws Exception {
        Python.assumeZmq();
        try (BridgeProcess bridge = start(); WireClient wire = new WireClient(bridge)) {
            String before = begin(wire);
            for (String kind : List.of("PUSH stream frame", "PUSH stream parts", "DEALER command frame", "DEALER command parts")) {
                String[] how = kind.split(" ");
                try (Python sensor = Python.program(folder, HalfWay.MID_FRAME, how[0], bridge.port(how[1]), how[2])) {
                    sensor.untilPrinted("sent");
                    kill(sensor);
                }
                assertEquals(before, GoodMessages.belief(wire.ask(STATE)), kind);
            }
            wire.listen("belief");
            wire.push("{'v':1,'type':'speech','text':'silver','id':'after'}");
            wire.until(e -> e.path("re").asText().equals("after"));
        }
    }

    @Test
    void aRobotKilledWhileItsDecisionIsMade() throws Exception {
        Python.assumeZmq();
        try (BridgeProcess bridge = BridgeProcess.start(folder, "kitchen-20", "--solver", "poss:H=3,C=10");
                WireClient wire = new WireClient(bridge)) {
            String belief;
            try (Python robot = Python.program(folder, HalfWay.AFTER_DECIDE, bridge.address("command"))) {
                robot.untilPrinted("asked");
                belief = GoodMessages.belief(wire.must(STATE));
                kill(robot);
            }
            JsonNode decision = wire.must("{'v':1,'type':'decide','deadline_ms':200}");
            assertEquals("decision", decision.get("type").asText());
            assertEquals(1, decision.get("belief_version").asInt());
            Thread.sleep(3500);
            assertEquals(belief, GoodMessages.belief(wire.ask(STATE)), "no decision moves the belief");
            assertTrue(bridge.isAlive());
        }
    }

    @Test
    void repeatedMessagesCountOnce() throws Exception {
        try (BridgeProcess bridge = start(); WireClient wire = new WireClient(bridge); WireClient other = new WireClient(bridge)) {
            begin(wire);
            String speech = "{'v':1,'type':'speech','text':'silver','id':'7','source':'mic'}";
            int version = wire.must(speech).get("belief").asInt();
            String belief = GoodMessages.belief(wire.ask(STATE));
            wire.listen("belief");
            for (int k = 0; k < 50; k++) {
                assertEquals(version, wire.must(speech).get("belief").asInt());
                assertEquals(version, other.must(speech).get("belief").asInt());
                wire.push(speech);
            }
            assertEquals(belief, GoodMessages.belief(wire.ask(STATE)));
            wire.push(speech.replace("mic", "the same id of another source"));
            assertEquals(version + 1, wire.until(e -> true).get("belief_version").asInt());
        }
    }

    /** A subscriber that never reads costs the others nothing: one that does read misses nothing. */
    @Test
    void aSlowSubscriber() throws Exception {
        Python.assumeZmq();
        try (BridgeProcess bridge = start(); WireClient wire = new WireClient(bridge);
                Python deaf = Python.program(folder, HalfWay.DEAF, bridge.address("command"))) {
            deaf.untilPrinted("deaf");
            wire.listen("belief");
            begin(wire);
            for (int k = 0; k < 8_000; k++) {
                int version = wire.must(k % 100 == 0 ? "{'v':1,'type':'begin'}" : "{'v':1,'type':'speech','text':'large silver bowl'}")
                        .get("belief").asInt();
                assertEquals(version, wire.until(e -> e.get("belief_version").asInt() > 3).get("belief_version").asInt());
            }
            assertTrue(deaf.process().isAlive() && bridge.isAlive());
        }
    }

    /** Connections that never say what they are, or stop in the greeting. */
    @Test
    void aThousandHalfOpenClients() throws Exception {
        try (BridgeProcess bridge = start(); WireClient wire = new WireClient(bridge)) {
            String before = begin(wire);
            List<Socket> open = new ArrayList<>();
            try {
                for (int k = 0; k < CONNECTIONS; k++) {
                    Socket socket = new Socket();
                    socket.connect(new InetSocketAddress("127.0.0.1", bridge.port(List.of("command", "stream", "events").get(k % 3))), 30_000);
                    open.add(socket);
                    OutputStream out = socket.getOutputStream();
                    switch (k % 4) {
                        case 0 -> { }
                        case 1 -> out.write(new byte[] {(byte) 0xff, 0, 0});
                        case 2 -> out.write("GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
                        default -> out.write(new byte[] {(byte) 0xff, 0, 0, 0, 0, 0, 0, 0, 0, 0x7f, 3});
                    }
                    if (k % 100 == 0) {
                        assertEquals(before, GoodMessages.belief(wire.ask(STATE)));
                    }
                }
                try (WireClient late = new WireClient(bridge)) {
                    late.must("{'v':1,'type':'speech','text':'silver'}");
                    wire.listen("belief");
                    late.push("{'v':1,'type':'speech','text':'silver','id':'s'}");
                    assertNotNull(wire.until(e -> e.path("re").asText().equals("s")));
                }
            } finally {
                for (Socket socket : open) {
                    socket.close();
                }
            }
            assertEquals("ok", wire.ask("{'v':1,'type':'speech','text':'silver'}").get("type").asText());
            assertTrue(bridge.isAlive());
        }
    }

    /** More than can be applied: gestures give way, and are counted; final speech is applied or refused, each of it. */
    @Test
    void aFloodOfGesturesGivesWayToSpeech() throws Exception {
        try (BridgeProcess bridge = BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", "--queue", "50");
                WireClient wire = new WireClient(bridge)) {
            begin(wire);
            wire.listen("belief", "error");
            JsonNode before = wire.must(STATE).get("counters");
            int sent = 30_000;
            for (int k = 0; k < sent; k++) {
                wire.push(k % 100 == 0 ? "{'v':1,'type':'speech','text':'silver','id':'final" + k + "','source':'mic'}"
                        : "{'v':1,'type':'gesture','hand':[0.05,0.9,0.15],'shoulder':[0.15,1.4,0.35]}");
            }
            Set<String> finals = new HashSet<>();
            while (finals.size() < sent / 100) {
                JsonNode event = wire.until(e -> e.path("re").asText().startsWith("final"));
                assertTrue(event.get("type").asText().equals("belief") || event.get("code").asText().equals("busy"), event.toString());
                assertTrue(finals.add(event.get("re").asText()), "told twice: " + event);
            }
            JsonNode after = wire.must(STATE).get("counters");
            for (int tick = 0; settled(after) - settled(before) < sent; tick++) {
                assertTrue(tick < 600, sent + " sent, " + before + " became " + after);
                Thread.sleep(50);
                after = wire.must(STATE).get("counters");
            }
            assertEquals(sent, settled(after) - settled(before), "each message counts once: " + after);
            assertEquals(sent, after.get("streamed").asInt() - before.path("streamed").asInt());
            System.out.println("of " + sent + " messages at once " + after.path("shed").asInt() + " were shed");
        }
    }

    private static int settled(JsonNode counters) {
        return counters.path("applied").asInt() + counters.path("shed").asInt() + counters.path("errors").asInt();
    }

    private BridgeProcess start() throws Exception {
        return BridgeProcess.start(folder, DOMAIN, "--solver", "confirm");
    }

    /** Begins an episode with something in it; the beliefs then. */
    private static String begin(WireClient wire) throws Exception {
        wire.must("{'v':1,'type':'begin'}");
        wire.must("{'v':1,'type':'speech','text':'a spoon'}");
        wire.must("{'v':1,'type':'acted','act':'ASK','objects':['silver_spoon'],'status':'started'}");
        return GoodMessages.belief(wire.must(STATE));
    }

    /** kill -9. */
    private static void kill(Python process) throws InterruptedException {
        process.process().destroyForcibly().waitFor();
    }
}
