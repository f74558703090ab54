package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whole handovers: a bridge, a simulated person and a simulated robot, each a process of its own. */
class EndToEndTest {
    private static final int SEEDS = 4;

    @TempDir
    Path folder;

    @BeforeAll
    static void needsPython() throws Exception {
        Python.assumeZmq();
    }

    @Test
    void thePersonGetsWhatTheyWant() throws Exception {
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "poss:H=2,C=5")) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                handover(bridge, seed);
            }
            assertTrue(bridge.isAlive(), bridge.errors());
        }
    }

    @Test
    void aPickMayTakeThreeIncrements() throws Exception {
        try (BridgeProcess bridge = BridgeProcess.start(folder, "bowls-incremental", "--solver", "poss:H=2,C=5")) {
            String robot = handover(bridge, 7);
            assertTrue(robot.split("PICK\\(", -1).length > 3, robot);
        }
    }

    /** A person whose words, gestures and answers are not what the robot believes of people is served too. */
    @Test
    void thePersonMayBeUnlikeTheModel() throws Exception {
        Path human = Path.of("domains/humans/sloppy-pointer.json").toAbsolutePath();
        try (BridgeProcess bridge = BridgeProcess.start(folder, "bowls-and-spoons", "--solver", "poss:H=2,C=5")) {
            handover(bridge, 5, "--human", human);
        }
    }

    /** What is recorded of an episode is all there: every version of the belief once, acts as the robot did them. */
    @Test
    void observersSeeAll() throws Exception {
        Path record = folder.resolve("record.jsonl");
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "confirm");
                Python recorder = Python.script(folder, "record.py", "--bridge", bridge.address("command"), "--out", record);
                Python watch = Python.script(folder, "watch.py", "--bridge", bridge.address("command"))) {
            watch.untilPrinted("no episode yet");
            for (int tick = 0; !Files.exists(record) || Files.readString(record).isEmpty(); tick++) {
                assertTrue(tick < 600, recorder.text());
                Thread.sleep(50);
            }
            String robot = handover(bridge, 3);
            watch.untilPrinted("episode: end");
            for (int tick = 0; !Files.readString(record).contains("\"event\": \"end\""); tick++) {
                assertTrue(tick < 600, recorder.text());
                Thread.sleep(50);
            }
            recorder.process().destroy();
            List<JsonNode> events = Files.readAllLines(record).stream().map(EndToEndTest::json).toList();
            List<Long> versions = events.stream().filter(e -> e.get("topic").asText().equals("belief"))
                    .map(e -> e.get("event").get("belief_version").asLong()).toList();
            for (int k = 0; k < versions.size(); k++) {
                assertEquals(versions.get(0) + k, versions.get(k), versions.toString());
            }
            long started = events.stream().filter(e -> e.get("topic").asText().equals("act"))
                    .filter(e -> e.get("event").get("status").asText().equals("started")).count();
            assertEquals(robot.lines().filter(l -> l.contains(" after ")).count(), started, robot);
        }
    }

    /** Recorded landmarks of somebody who points to the right, past the red ball, seen by a camera at the robot. */
    @Test
    void aRecordedGestureMovesTheBelief() throws Exception {
        String domain = Path.of("src/test/resources/golden/bridge/table.json").toAbsolutePath().toString();
        try (BridgeProcess bridge = BridgeProcess.start(folder, domain, "--solver", "confirm"); WireClient wire = new WireClient(bridge)) {
            wire.must("{'v':1,'type':'begin'}");
            try (Python camera = Python.script(folder, "gesture_mediapipe.py", "--bridge", bridge.address("command"), "--landmarks",
                    Python.SCRIPTS.resolve("tests/landmarks.ndjson"))) {
                assertEquals("right arm points, belief 2\n", camera.ended(0));
            }
            JsonNode belief = wire.must("{'v':1,'type':'state'}").get("belief");
            assertTrue(belief.get("red_ball").asDouble() > 0.5, belief.toString());
        }
    }

    private String handover(BridgeProcess bridge, int seed, Object... more) throws Exception {
        String hand = "ipc://" + folder.resolve("hand-" + seed);
        Object[] person = {"--bridge", bridge.address("command"), "--hand", hand, "--seed", seed, "--scale", 0.02};
        Object[] all = new Object[person.length + more.length];
        System.arraycopy(person, 0, all, 0, person.length);
        System.arraycopy(more, 0, all, person.length, more.length);
        try (Python somebody = Python.script(folder, "sensor_sim.py", all)) {
            somebody.untilPrinted("ready, wants ");
            String wanted = somebody.text().lines().findFirst().orElseThrow().substring("ready, wants ".length());
            try (Python robot = Python.script(folder, "robot_sim.py", "--bridge", bridge.address("command"), "--hand", hand,
                    "--scale", 0.02, "--deadline-ms", 100, "--acts", 1000)) {
                String did = robot.ended(0);
                assertTrue(did.contains("end: 1 handed over, "), did);
                assertTrue(somebody.ended(0).endsWith("takes " + wanted + "\n"), somebody.text());
                return did;
            }
        }
    }

    private static JsonNode json(String line) {
        try {
            return BridgeProcess.JSON.readTree(line);
        } catch (IOException e) {
            throw new AssertionError(line, e);
        }
    }
}
