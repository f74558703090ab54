package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** End to end with real parts: a voice says what it wants, a recogniser hears it, and the robot is told what to do. */
class SpokenTest {
    @TempDir
    Path folder;

    @Test
    void theRedBallIsHeardAndDecidedOn() throws Exception {
        Python.assumeZmq();
        Python.assumeModule("pocketsphinx", "pip install -r scripts/requirements-speech.txt");
        Python.assume(List.of("espeak-ng", "--version"), "espeak-ng", "apt-get install espeak-ng");
        Path wav = folder.resolve("said.wav");
        Process voice = new ProcessBuilder("espeak-ng", "-v", "en-us", "-w", wav.toString(), "give me the red ball").start();
        assertTrue(voice.waitFor(1, TimeUnit.MINUTES) && voice.exitValue() == 0);
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "poss:H=2,C=5");
                WireClient wire = new WireClient(bridge)) {
            wire.must("{'v':1,'type':'begin'}");
            try (Python hearing = Python.script(folder, "speech_pocketsphinx.py", "--bridge", bridge.address("command"), "--wav",
                    wav)) {
                assertTrue(hearing.ended(0).contains("heard \"give me the red ball\", belief 2"), hearing.text());
            }
            JsonNode belief = wire.must("{'v':1,'type':'state'}").get("belief");
            assertTrue(belief.get("red_ball").asDouble() > 0.5, belief.toString());
            try (Python robot = Python.program(folder, """
                    import json, sys
                    from client import Bridge
                    with Bridge(sys.argv[1], source="robot") as bridge:
                        print(json.dumps(bridge.ask("decide", deadline_ms=2000)))
                    """, bridge.address("command"))) {
                JsonNode decision = BridgeProcess.JSON.readTree(robot.ended(0));
                assertEquals("[\"red_ball\"]", decision.get("objects").toString(), decision.toString());
                assertEquals(2, decision.get("belief_version").asInt());
            }
        }
    }
}
