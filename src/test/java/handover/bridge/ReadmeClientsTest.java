package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The Python programs that the README shows are run as they stand, but for the address. */
class ReadmeClientsTest {
    private static final String IMPORTS = "import sys, time\nfrom client import Bridge\n";

    @TempDir
    Path folder;

    @BeforeAll
    static void needsPython() throws Exception {
        Python.assumeZmq();
    }

    /** With a person who says yes to every question. */
    @Test
    void tenLinesAreARobot() throws Exception {
        String robot = shown(0).replace("Bridge(source", "Bridge(sys.argv[1], source");
        String body = """
                class Body:
                    def do(self, decision):
                        print(decision["act"])
                        if decision["act"] == "ASK":
                            bridge.ask("speech", text="yes")
                        return "accepted" if decision["act"] == "PICK" else None
                my_robot = Body()
                """;
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "confirm");
                Python program = Python.program(folder, IMPORTS + body + robot, bridge.address("command"))) {
            assertEquals(List.of("ASK", "PICK"), program.ended(0).lines().toList());
        }
    }

    @Test
    void threeLinesAreSensors() throws Exception {
        String begin = "bridge = Bridge(sys.argv[1], source='sensors')\nbridge.ask('begin')\n";
        try (BridgeProcess bridge = BridgeProcess.start(folder, "table-line-6", "--solver", "confirm");
                WireClient wire = new WireClient(bridge);
                Python program = Python.program(folder, IMPORTS + begin + shown(1) + "bridge.close()\n", bridge.address("command"))) {
            assertEquals("", program.ended(0));
            JsonNode state = wire.must("{'v':1,'type':'state'}");
            for (int tick = 0; state.get("counters").get("applied").asInt() < 4; tick++) {
                assertTrue(tick < 600, state.toString());
                Thread.sleep(50);
                state = wire.must("{'v':1,'type':'state'}");
            }
            assertTrue(state.get("belief").get("red_ball").asDouble() > 0.5, state.toString());
        }
    }

    /** A block of Python in the README. */
    private static String shown(int which) throws IOException {
        List<MatchResult> blocks = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(Path.of("README.md")))
                .results().toList();
        assertEquals(2, blocks.size());
        return blocks.get(which).group(1);
    }
}
