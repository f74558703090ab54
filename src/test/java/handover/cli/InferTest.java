package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Messages in, beliefs out. The domain is small enough to compute with a pencil: two objects, each with one word of its own,
 * alpha = 0.5, so that p(red | cup) = 1.5 / 2 and p(red | box) = 0.5 / 2; seen from the shoulder they are a right angle apart.
 */
class InferTest {
    private static final double EXACT = 1e-12;

    @TempDir
    Path folder;
    private String domain;

    @BeforeEach
    void writeDomain() throws IOException {
        domain = Files.writeString(folder.resolve("two.json"), """
                {"name": "two", "shoulder": [0, 0, 1], "speech": {"alpha": 0.5}, "gesture": {"variance": 0.5, "outliers": 0},
                 "objects": [{"name": "cup", "position": [1, 0, 1], "words": {"red": 1}, "label": "red"},
                             {"name": "box", "position": [0, 1, 1], "words": {"blue": 1}, "label": "blue"}]}
                """).toString();
    }

    @Test
    void aConversation() {
        List<JsonNode> replies = infer("""
                {"v": 1, "type": "begin", "id": "b"}
                {"v": 1, "type": "speech", "text": "the red one"}
                {"v": 1, "type": "acted", "act": "ASK", "objects": ["cup"], "status": "started"}
                {"v": 1, "type": "speech", "text": "yes"}
                {"v": 1, "type": "acted", "act": "ASK", "objects": ["cup"], "status": "completed"}
                {"v": 1, "type": "acted", "act": "PICK", "objects": ["cup"], "status": "completed", "pick": "accepted"}
                """);
        assertEquals("b", replies.get(0).get("re").asText());
        assertBelief(0.5, 0.5, replies.get(0));
        assertBelief(0.75, 0.5, replies.get(1));
        assertEquals("[\"the\",\"one\"]", replies.get(1).get("unknown_words").toString());
        assertBelief(0.75, 0.75, replies.get(2));
        assertEquals("{\"act\":\"ASK\",\"objects\":[\"cup\"]}", replies.get(2).get("open_reference").toString());
        double yesIfCup = 0.75 * 0.95 * 0.99;
        double yesIfBox = 0.25 * 0.95 * 0.01;
        assertBelief(yesIfCup / (yesIfCup + yesIfBox), 0.75, replies.get(3));
        assertTrue(replies.get(3).get("open_reference").isNull());
        assertEquals(replies.get(3).get("belief"), replies.get(4).get("belief"));
        assertEquals("{\"box\":1.0}", replies.get(5).get("belief").toString());
        assertTrue(replies.get(5).get("done").asBoolean());
        assertTrue(replies.stream().allMatch(r -> r.get("v").asInt() == 1 && r.get("type").asText().equals("belief")));
    }

    @Test
    void gesturesAndUncertainSpeech() {
        List<JsonNode> replies = infer("""
                {"v":1,"type":"gesture","shoulder":[0,0,1],"hand":[0.5,0,1],"confidence":0.5,"t":1763800000.12}
                {"v":1,"type":"begin","prior":{"cup":0.2,"box":0.8}}
                {"v":1,"type":"gesture","side":"left","joints":{"shoulder_left":[0,0,1],"wrist_left":[0,0.5,1]},"frame":"table"}
                {"v":1,"type":"begin"}
                {"v":1,"type":"speech","alternatives":[{"transcript":"red","confidence":0.6},{"transcript":"blue","confidence":0.2}]}
                """);
        double ratio = Math.exp(-Math.PI * Math.PI / 4);
        assertBelief(1 / (1 + ratio), 0.5, replies.get(0));
        assertBelief(0.2, 0.5, replies.get(1));
        assertBelief(0.2 * ratio / (0.2 * ratio + 0.8), 0.5, replies.get(2));
        assertBelief(0.75 * 0.75 + 0.25 * 0.25, 0.5, replies.get(4));
    }

    @Test
    void whatTellsNothingIsSaid() {
        List<JsonNode> replies = infer("""
                {"v":1,"type":"speech","text":"red","final":false}
                {"v":1,"type":"speech","text":"yes"}
                {"v":1,"type":"speech","text":"hello"}

                {"v":1,"type":"state"}
                """);
        assertBelief(0.5, 0.5, replies.get(0));
        assertFalse(replies.get(0).get("final").asBoolean(true));
        assertTrue(replies.get(1).get("uninformative").asBoolean(), "nothing was asked");
        assertFalse(replies.get(2).has("uninformative"));
        assertEquals("[\"hello\"]", replies.get(2).get("unknown_words").toString());
        assertEquals("state", replies.get(3).get("type").asText());
        assertEquals(4, replies.size(), "an empty line is no message");
    }

    @Test
    void aMessageIsAppliedOncePerSource() {
        List<JsonNode> replies = infer("""
                {"v":1,"type":"speech","text":"red","id":"1","source":"a"}
                {"v":1,"type":"speech","text":"red","id":"1","source":"a"}
                {"v":1,"type":"speech","text":"red","id":"1","source":"b"}
                {"v":1,"type":"speech","text":"red","id":"2","source":"a","final":3}
                {"v":1,"type":"speech","text":"red","id":"2","source":"a"}
                {"v":1,"type":"end","id":"3"}
                {"v":1,"type":"end","id":"3"}
                {"v":1,"type":"end","id":"4"}
                """);
        assertBelief(0.75, 0.5, replies.get(0));
        assertEquals(replies.get(0), replies.get(1));
        assertBelief(0.9, 0.5, replies.get(2));
        assertEquals("error", replies.get(3).get("type").asText());
        assertBelief(27.0 / 28, 0.5, replies.get(4));
        assertEquals("summary", replies.get(5).get("type").asText());
        assertEquals("3", replies.get(6).get("re").asText());
        assertEquals("belief", replies.get(6).get("type").asText(), "acknowledged again");
        assertEquals("no_episode", replies.get(7).get("code").asText());
    }

    @Test
    void aPickMayTakeSeveralIncrements() {
        String increment = "{\"v\":1,\"type\":\"acted\",\"act\":\"PICK\",\"objects\":[\"color_bowl\"],"
                + "\"status\":\"completed\",\"pick\":\"%s\"}\n";
        Output o = Output.withInput(increment.formatted("moving").repeat(2) + increment.formatted("moving")
                + "{\"v\":1,\"type\":\"state\"}\n" + increment.formatted("accepted"), "infer", "bowls-incremental");
        List<JsonNode> replies = o.lines().stream().map(InferTest::json).toList();
        assertEquals("belief", replies.get(1).get("type").asText());
        assertEquals("bad_field", replies.get(2).path("code").asText(), "the third increment completes the pick");
        assertEquals(2, replies.get(3).get("progress").asInt());
        assertEquals("color_bowl", replies.get(3).get("target").asText());
        assertTrue(replies.get(4).get("done").asBoolean());
    }

    private void assertBelief(double cup, double expected, JsonNode reply) {
        assertEquals(cup, reply.get("belief").get("cup").doubleValue(), EXACT, reply.toString());
        assertEquals(1 - cup, reply.get("belief").get("box").doubleValue(), EXACT, reply.toString());
        assertEquals(expected, reply.get("human_belief").get("cup").doubleValue(), EXACT, reply.toString());
    }

    private List<JsonNode> infer(String lines) {
        Output o = Output.withInput(lines, "infer", domain);
        assertEquals(Main.FINE, o.code(), o.err());
        List<JsonNode> replies = new ArrayList<>();
        o.lines().forEach(line -> replies.add(json(line)));
        return replies;
    }

    private static JsonNode json(String line) {
        try {
            return new ObjectMapper().readTree(line);
        } catch (IOException e) {
            throw new AssertionError(line, e);
        }
    }
}
