package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.SessionHeader;
import handover.io.SessionLogReader;
import handover.io.SessionLogWriter;
import handover.math.Streams;
import handover.solver.Confirm;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What came first counts first, however much of the stream waits to be applied. */
class OrderTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("table-line-6");
    private static final String ASK = "{'v':1,'type':'acted','act':'ASK','objects':['%s'],'status':'%s'}";
    private static final int BACKLOG = 3000;
    private static final int STOPPED_WITH = 4000;

    @TempDir
    Path folder;

    /** A "yes" without time that the bridge had got before the robot went on is to the question before. */
    @Test
    void aYesBehindABacklogIsToTheQuestionThatWasOpenWhenItCame() throws Exception {
        Path log = folder.resolve("log.jsonl");
        JsonNode after;
        try (SessionLogWriter writer = SessionLogWriter.create(log, new SessionHeader(DOMAIN.spec(), "confirm", 1, 2));
                RunningBridge bridge = RunningBridge.of(DOMAIN, new Confirm(), RunningBridge.SETTINGS, Recovery.none(DOMAIN, 1, 2), writer)) {
            bridge.ask("{'v':1,'type':'begin','prior':{'red_ball':0.4,'blue_ball':0.4,'green_marker':0.2}}");
            bridge.ask(ASK.formatted("red_ball", "started"));
            for (int k = 0; k < BACKLOG; k++) {
                bridge.push("{'v':1,'type':'speech','text':'hmm'}");
            }
            bridge.push("{'v':1,'type':'speech','text':'yes'}");
            while (bridge.ask("{'v':1,'type':'state'}").get("counters").path("streamed").asInt() <= BACKLOG) {
                Thread.onSpinWait();
            }
            int version = bridge.ask(ASK.formatted("red_ball", "completed")).get("belief").asInt();
            assertTrue(version < BACKLOG, "a command does not wait for what was sensed: " + version);
            bridge.ask(ASK.formatted("blue_ball", "started"));
            after = bridge.stateAfter(BACKLOG + 1);
            for (int k = 0; k < 1000 && after.get("belief_version").asInt() < BACKLOG + 5; k++) {
                Thread.sleep(20); // acts count, too
                after = bridge.ask("{'v':1,'type':'state'}");
            }
            assertEquals(BACKLOG + 5, after.get("belief_version").asInt());
            assertTrue(after.get("belief").get("red_ball").asDouble() > 0.9, after.toString());
        }
        try (SessionLogReader reader = SessionLogReader.open(log)) {
            Recovery recovery = Recovery.of(reader);
            assertNull(recovery.difference());
            assertEquals(after.get("belief").get("red_ball").asDouble(), recovery.session().now().belief().probabilities()[1]);
        }
    }

    /** Told to stop, a bridge applies what it has, and says of how much it could not. */
    @Test
    void whatWaitsWhenTheBridgeIsToldToStopIsAppliedOrCounted() throws Exception {
        Path log = folder.resolve("log.jsonl");
        try (SessionLogWriter writer = SessionLogWriter.create(log, new SessionHeader(DOMAIN.spec(), "confirm", 1, 2));
                RunningBridge bridge = RunningBridge.of(DOMAIN, new Confirm(), RunningBridge.SETTINGS, Recovery.none(DOMAIN, 1, 2), writer)) {
            bridge.ask("{'v':1,'type':'begin'}");
            for (int k = 0; k < STOPPED_WITH; k++) {
                bridge.push("{'v':1,'type':'speech','text':'red','id':'" + k + "','source':'mic'}");
            }
            while (bridge.ask("{'v':1,'type':'state'}").get("counters").path("streamed").asInt() < STOPPED_WITH) {
                Thread.onSpinWait();
            }
            assertTrue(bridge.stop());
        }
        List<String> lines = Files.readAllLines(log);
        long applied = lines.stream().filter(line -> line.contains("\"source\":\"mic\"")).count();
        Matcher left = Pattern.compile("(\\d+) messages of the stream were not applied").matcher(lines.get(lines.size() - 1));
        assertEquals(STOPPED_WITH, applied + (left.find() ? Integer.parseInt(left.group(1)) : 0), applied + " were applied");
        assertTrue(applied > 0);
    }

    @Test
    void whatIsNotAppliedAtTheEndIsCountedAndPublished() {
        List<String> events = new ArrayList<>();
        Outbox outbox = new Outbox() {
            @Override
            public void reply(Client client, String json) {
                events.add(json);
            }

            @Override
            public void publish(String topic, Supplier<String> json) {
                events.add(topic + " " + json.get());
            }
        };
        Service service = new Service(Session.of(DOMAIN, 1, 2), new Confirm().solve(DOMAIN, Streams.of(1, "solve", 0)), null,
                RunningBridge.SETTINGS, outbox, null, () -> 100, System::nanoTime, plan -> { });
        for (int k = 0; k < 3; k++) {
            service.stream("{\"v\":1,\"type\":\"speech\",\"text\":\"red\"}".getBytes(StandardCharsets.UTF_8));
        }
        service.close();
        assertEquals(1, events.size());
        assertTrue(events.get(0).startsWith("error ") && events.get(0).contains("3 messages of the stream were not applied"),
                events.get(0));
    }
}
