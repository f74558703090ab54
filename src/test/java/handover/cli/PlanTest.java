package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** One decision, for people and for programs. */
class PlanTest {
    @TempDir
    Path folder;

    @Test
    void forPeople() {
        Output o = Output.of("plan", "--solver", "poss:H=1", "--belief", "metal_bowl=0.25,silver_spoon=0.75");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().startsWith("""
                bowls-and-spoons, poss:H=1,C=10

                object         robot believes  person expects
                metal_bowl             0.2500          0.2500
                color_bowl             0.0000          0.2500
                plastic_spoon          0.0000          0.2500
                silver_spoon           0.7500          0.2500

                best:\s"""), o.out());
        assertTrue(o.out().contains("looked 1 acts ahead at "), o.out());
        assertTrue(o.out().endsWith("\nand 7 more (--all)\n"), o.out());
        assertEquals(o.lines().size() - 1 + 7, Output.of("plan", "--solver", "poss:H=1", "--all", "--belief",
                "metal_bowl=0.25,silver_spoon=0.75").lines().size());
    }

    @Test
    void forPrograms() throws IOException {
        Path belief = Files.writeString(folder.resolve("b.json"), "{\"silver_spoon\": 1}");
        Output o = Output.of("plan", "--solver", "poss:H=2,C=3", "--json", "--belief", belief.toString(), "--human-belief",
                belief.toString());
        assertEquals(Main.FINE, o.code(), o.err());
        JsonNode reply = new ObjectMapper().readTree(o.out());
        assertEquals("PICK", reply.get("act").asText());
        assertEquals("silver_spoon", reply.get("objects").get(0).asText());
        assertEquals(1.0, reply.get("belief").get("silver_spoon").asDouble());
        assertEquals(1.0, reply.get("human_belief").get("silver_spoon").asDouble());
        assertEquals(2, reply.get("depth").asInt());
        assertTrue(reply.get("finished").asBoolean());
        assertTrue(reply.get("nodes").asLong() > 0);
        assertTrue(reply.get("ms").asDouble() >= 0);
        List<Double> values = new ArrayList<>();
        reply.get("values").forEach(v -> values.add(v.asDouble()));
        assertEquals(17, values.size());
        assertEquals(values.stream().sorted(Comparator.reverseOrder()).toList(), values);
        assertEquals("PICK(silver_spoon)", reply.get("values").fieldNames().next());
    }

    @Test
    void aDeadlineIsKept() {
        Output o = Output.of("plan", "--solver", "poss:H=9,C=50", "--deadline-ms", "30");
        assertEquals(Main.FINE, o.code(), o.err());
        assertTrue(o.out().contains("stopped by the deadline"), o.out());
    }

    @Test
    void solversWithoutValuesHaveNoTable() {
        Output o = Output.of("plan", "--solver", "confirm", "--belief", "silver_spoon=1");
        assertTrue(o.out().contains("best: ASK(silver_spoon), saying \"silver spoon\"\n"), o.out());
        assertTrue(o.out().endsWith("finished\n"), o.out());
    }

    @Test
    void badFilesAreNamed() throws IOException {
        Path belief = Files.writeString(folder.resolve("b.json"), "{\"silver_spoon\": \"much\"}");
        Output o = Output.of("plan", "--belief", belief.toString());
        assertEquals("handover: " + belief + ": silver_spoon: expected a probability in [0, 1], got \"much\"\n", o.err());
        assertEquals(Main.BAD_INPUT, o.code());
    }
}
