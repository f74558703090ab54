package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
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
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The log alone is enough: the same beliefs bit for bit, the same versions, and ids that are still known. */
class RecoveryTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("table-line-6-incremental");

    @TempDir
    Path folder;

    private Recovery read(Path log) throws IOException {
        try (SessionLogReader reader = SessionLogReader.open(log)) {
            Recovery recovery = Recovery.of(reader);
            assertEquals(recovery.difference() == null && Files.size(log) > recovery.end(), reader.torn());
            return recovery;
        }
    }

    private SessionLogWriter create(Path log) throws IOException {
        return SessionLogWriter.create(log, new SessionHeader(DOMAIN.spec(), "confirm", 1, 2));
    }

    private static RunningBridge bridge(Recovery start, SessionLogWriter log) {
        return RunningBridge.of(DOMAIN, new Confirm(), RunningBridge.SETTINGS, start, log);
    }

    @Test
    void aBridgeGoesOnWhereItsLogEnds() throws IOException {
        Path log = folder.resolve("log.jsonl");
        JsonNode before;
        Path copy = folder.resolve("copy.jsonl");
        try (SessionLogWriter writer = create(log); RunningBridge bridge = bridge(Recovery.none(DOMAIN, 1, 2), writer)) {
            converse(bridge, Streams.of(7, "conversation", 0));
            before = bridge.ask("{'v':1,'type':'state'}");
            Files.copy(log, copy);
        }
        Files.writeString(copy, "{\"at\":1763800000.5,\"mess", StandardOpenOption.APPEND);
        Recovery recovery = read(copy);
        assertNull(recovery.difference());
        assertTrue(recovery.messages() > 150, recovery.toString());
        try (SessionLogWriter writer = SessionLogWriter.append(copy, recovery.end()); RunningBridge again = bridge(recovery, writer)) {
            JsonNode after = again.ask("{'v':1,'type':'state'}");
            for (String same : List.of("belief", "human_belief", "belief_version", "episode", "open_reference", "target",
                    "progress", "handovers", "scene", "done")) {
                assertEquals(before.get(same), after.get(same), same);
            }
            JsonNode repeated = again.ask("{'v':1,'type':'speech','text':'red','id':'known','source':'mic'}");
            assertEquals(before.get("belief_version"), repeated.get("belief"), "this id was applied before the crash");
            again.ask("{'v':1,'type':'begin','id':'after the crash'}");
        }
        Recovery whole = read(copy);
        assertNull(whole.difference());
        assertEquals(recovery.messages() + 1, whole.messages());
    }

    /** Everything that moves a belief, and much that does not. */
    private static void converse(RunningBridge bridge, RandomGenerator random) {
        for (int episode = 0; episode < 4; episode++) {
            bridge.ask("{'v':1,'type':'begin','id':'b" + episode + "','source':'robot'}");
            for (int k = 0; k < 60; k++) {
                double t = System.currentTimeMillis() / 1e3 - random.nextDouble() * 0.2;
                String object = DOMAIN.start().objects().get(random.nextInt(6)).name();
                String message = switch (random.nextInt(8)) {
                    case 0 -> "'type':'decide'";
                    case 1 -> "'type':'acted','act':'ASK','objects':['" + object + "'],'status':'started'";
                    case 2 -> "'type':'acted','act':'PICK','objects':['" + object + "'],'status':'started'";
                    case 3 -> "'type':'acted','act':'ASK','objects':['" + object + "'],'status':'cancelled'";
                    case 4 -> "'type':'scene','objects':[{'name':'" + object + "','position':[" + random.nextDouble() + ",0.5,0.1]}]";
                    case 5 -> "'type':'speech','text':'" + List.of("yes", "no", "the blue\\n ball", "not the marker")
                            .get(random.nextInt(4)) + "'";
                    case 6 -> String.format(Locale.ROOT, "'type':'gesture','hand':[%.9f,0.9,0.1],'shoulder':[0.15,1.4,0.35]",
                            random.nextGaussian());
                    default -> "'type':'speech','alternatives':[{'transcript':'red','confidence':0.5},"
                            + "{'transcript':'green','confidence':" + random.nextDouble() + "}]";
                };
                bridge.ask("{'v':1,'id':'" + episode + "-" + k + "','source':'mic',\n 't':" + t + "," + message + "}");
            }
            bridge.ask("{'v':1,'type':'end'}");
        }
        bridge.ask("{'v':1,'type':'begin'}");
        bridge.ask("{'v':1,'type':'acted','act':'PICK','objects':['red_ball'],'status':'completed','pick':'moving'}");
        bridge.ask("{'v':1,'type':'speech','text':'red','id':'known','source':'mic'}");
    }

    /** Also when the next episode has begun before the client asks again. */
    @Test
    void aSummaryThatGotLostIsGivenAfterARestart() throws IOException {
        Path log = folder.resolve("log.jsonl");
        String end = "{'v':1,'type':'end','id':'e','source':'robot'}";
        JsonNode summary;
        try (SessionLogWriter writer = create(log); RunningBridge bridge = bridge(Recovery.none(DOMAIN, 1, 2), writer)) {
            bridge.ask("{'v':1,'type':'begin'}");
            bridge.ask("{'v':1,'type':'acted','act':'PICK','objects':['red_ball'],'status':'completed','pick':'accepted'}");
            summary = bridge.ask(end);
            assertEquals("summary 1", summary.get("type").asText() + " " + summary.get("handovers"));
            bridge.ask("{'v':1,'type':'begin'}");
        }
        Recovery recovery = read(log);
        try (SessionLogWriter writer = SessionLogWriter.append(log, recovery.end()); RunningBridge again = bridge(recovery, writer)) {
            assertEquals(summary, again.ask(end));
            JsonNode other = again.ask(end.replace("end", "begin"));
            assertEquals("bad_field id", other.path("code").asText() + " " + other.path("path").asText(), other.toString());
            assertEquals(4, again.ask("{'v':1,'type':'state'}").get("belief_version").asInt());
        }
    }

    @Test
    void aLogThatWasChangedIsFound() throws IOException {
        Path log = folder.resolve("log.jsonl");
        try (SessionLogWriter writer = create(log); RunningBridge bridge = bridge(Recovery.none(DOMAIN, 1, 2), writer)) {
            bridge.ask("{'v':1,'type':'begin'}");
            bridge.ask("{'v':1,'type':'speech','text':'red'}");
            bridge.ask("{'v':1,'type':'speech','text':'blue'}");
        }
        String text = Files.readString(log);
        Path changed = Files.writeString(folder.resolve("changed.jsonl"), text.replace("\"text\":\"red\"", "\"text\":\"pink\""));
        assertNull(read(changed).difference(), "pink is as good a word for it");
        Files.writeString(changed, text.replace("\"text\":\"red\"", "\"text\":\"green\""));
        String difference = read(changed).difference();
        assertNotNull(difference);
        assertTrue(difference.startsWith("message 2: belief of "), difference);
        Files.writeString(changed, text.replace("\"belief_version\":2", "\"belief_version\":9"));
        assertEquals("message 2: logged version 9, computed 2", read(changed).difference());
    }

    @Test
    void everyLineIsWrittenBeforeItIsAnswered() throws IOException {
        Path log = folder.resolve("log.jsonl");
        try (SessionLogWriter writer = create(log); RunningBridge bridge = bridge(Recovery.none(DOMAIN, 1, 2), writer)) {
            for (String message : List.of("{'v':1,'type':'begin'}", "{'v':1,'type':'speech','text':'red'}", "{'v':1,'type':'decide'}",
                    "nonsense", "{'v':1,'type':'end'}")) {
                JsonNode reply = bridge.ask(message);
                List<String> lines = Files.readAllLines(log);
                assertTrue(lines.get(lines.size() - 1).contains(reply.get("type").asText()), lines.get(lines.size() - 1));
            }
            assertEquals(6, Files.readAllLines(log).size());
        }
    }
}
