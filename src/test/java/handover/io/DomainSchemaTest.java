package handover.io;

import static handover.io.BadDomains.json;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.ValueNode;
import handover.domain.DomainSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The schemas that editors use say the same as the reader: keys, defaults, ranges, and what is wrong with a file. */
class DomainSchemaTest {
    private static final Schema DOMAIN = Schema.of("domain");
    private static final Schema HUMAN = Schema.of("human");
    private static final DomainSpec SPEC = DomainFiles.fromJson(json(BadDomains.GOOD), "x");
    private static final ObjectNode WHOLE = DomainFiles.toJson(SPEC);

    static Stream<BadDomains.Bad> seenBySchema() {
        return BadDomains.all().filter(BadDomains.Bad::seenBySchema);
    }

    @ParameterizedTest
    @MethodSource("seenBySchema")
    void refusesWhatTheReaderRefuses(BadDomains.Bad bad) {
        assertFalse(DOMAIN.faults(json(bad.text())).isEmpty(), bad.text());
    }

    @Test
    void acceptsADomainWrittenOutInFull() {
        assertEquals(Set.of(), DOMAIN.faults(WHOLE));
    }

    @Test
    void knowsTheSameKeysAsTheReader() {
        assertEquals(Schema.keysOf(WHOLE), DOMAIN.keys(WHOLE));
    }

    @Test
    void knowsTheSameKeysOfHumansAsTheReader() {
        ObjectNode people = Overlay.merge(RecordMapper.tree(HumanFile.of(SPEC)),
                json("{'objects': [{'name': 'cup', 'words': {}}]}").deepCopy());
        assertEquals(Schema.keysOf(people), HUMAN.keys(people));
    }

    @Test
    void tellsTheDefaultsOfTheReader() {
        List<String> told = new ArrayList<>();
        for (String path : Schema.keysOf(WHOLE)) {
            JsonNode value = DOMAIN.at(path).get("default");
            if (value != null) {
                assertEquals(SPEC, DomainFiles.fromJson(having(path, value), "x"), path);
                told.add(path);
            }
        }
        for (String path : Schema.keysOf(WHOLE)) {
            boolean leaf = !path.startsWith("objects") && !path.equals("name") && Schema.keysOf(WHOLE).stream()
                    .noneMatch(other -> other.startsWith(path + "."));
            assertTrue(!leaf || told.stream().anyMatch(t -> path.equals(t) || path.startsWith(t + ".")), path);
        }
    }

    @Test
    void hasTheRangesOfTheReader() {
        List<String> checked = new ArrayList<>();
        for (String path : Schema.keysOf(WHOLE)) {
            JsonNode says = DOMAIN.at(path);
            for (int sign : new int[] {-1, 1}) {
                JsonNode bound = says.get(sign < 0 ? "minimum" : "maximum");
                if (bound != null) {
                    DomainFiles.fromJson(having(path, bound), "x");
                    ValueNode beyond = beyond(bound, sign, says.get("type").asText());
                    assertThrows(DomainFileException.class, () -> DomainFiles.fromJson(having(path, beyond), "x"), path);
                    checked.add(path);
                }
            }
        }
        assertTrue(checked.size() > 90, () -> "only " + checked);
    }

    @Test
    void hasTheChoicesOfTheReader() {
        for (String path : List.of("wrong_pick", "ask.sets", "rewards.match_score")) {
            List<String> choices = new ArrayList<>();
            DOMAIN.at(path).get("enum").forEach(c -> choices.add(c.asText()));
            ObjectNode wrong = having(path, JsonNodeFactory.instance.textNode("?"));
            DomainFileException e = assertThrows(DomainFileException.class, () -> DomainFiles.fromJson(wrong, "x"));
            assertEquals("expected one of " + String.join(", ", choices) + ", got \"?\"", e.problem());
        }
    }

    /** A good file that gives the value at the path. */
    private static ObjectNode having(String path, JsonNode value) {
        ObjectNode file = json(BadDomains.GOOD).deepCopy();
        ObjectNode node = file;
        String[] steps = path.split("\\.");
        for (int k = 0; k < steps.length - 1; k++) {
            node = node.withObjectProperty(steps[k]);
        }
        node.set(steps[steps.length - 1], value);
        return file;
    }

    private static ValueNode beyond(JsonNode bound, int sign, String type) {
        if (type.equals("integer")) {
            return JsonNodeFactory.instance.numberNode(bound.intValue() + sign);
        }
        double step = 1e-9 * Math.max(1, Math.abs(bound.doubleValue()));
        return JsonNodeFactory.instance.numberNode(bound.doubleValue() + sign * step);
    }
}
