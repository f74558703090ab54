package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every file is checked, whatever is wrong with those before it. */
class CheckTest {
    @TempDir
    Path folder;

    @Test
    void goodFilesAreSummedUp() {
        Output o = Output.of("check", "bowls-and-spoons", "table-line-6");
        assertEquals(Main.FINE, o.code());
        assertTrue(o.out().matches("ok: bowls-and-spoons: bowls-and-spoons, 4 objects, 17 acts, [0-9a-f]{16}\n"
                + "ok: table-line-6: table-line-6, 6 objects, 25 acts, [0-9a-f]{16}\n"), o.out());
        assertEquals("", o.err());
    }

    @Test
    void badFilesAreNamedAndTheRestIsCheckedToo() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.json"),
                "{\"name\": \"x\", \"objects\": [{\"name\": \"cup\", \"position\": [\"left\", 1, 0], \"words\": {}}]}");
        Output o = Output.of("check", bad.toString(), "bowls-and-spoons", "nothing");
        assertEquals(Main.BAD_INPUT, o.code());
        assertEquals("handover: " + bad + ": objects[0].position[0]: expected metres, got \"left\"",
                o.err().lines().findFirst().orElseThrow());
        assertEquals(2, o.err().lines().count());
        assertEquals(1, o.lines().size());
    }

    @Test
    void humanFilesAreCheckedWithTheirDomain() throws IOException {
        Path good = Files.writeString(folder.resolve("good.json"), "{\"tau\": 0.9}");
        Path bad = Files.writeString(folder.resolve("bad.json"), "{\"tau\": 9}");
        Output o = Output.of("check", "--human", "bowls-and-spoons", good.toString(), bad.toString());
        assertEquals(Main.BAD_INPUT, o.code());
        assertTrue(o.out().startsWith("ok: " + good + ": bowls-and-spoons, 4 objects, 17 acts, "), o.out());
        assertEquals("handover: " + bad + ": tau: expected a probability in [0, 1], got 9.0\n", o.err());
    }
}
