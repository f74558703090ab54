package handover.io;

import static handover.io.BadDomains.json;
import static handover.io.BadDomains.with;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import handover.domain.WrongPick;
import handover.math.MatchScore;
import handover.math.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a file leaves out is as in {@link DomainSpec#of}; what it says holds. */
class DomainFilesTest {
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("cup", new Vector3(0, 0.6, 0), Map.of("red", 1.0, "cup", 2.0), null),
            new TableObject("box", new Vector3(0.3, 0.6, 0), Map.of("red", 1.0, "box", 2.0), null));
    private static final DomainSpec SPEC = DomainSpec.of("x", OBJECTS);

    @TempDir
    Path folder;

    @Test
    void aFileWithoutParametersHasTheDefaults() {
        assertEquals(SPEC, read(BadDomains.GOOD));
    }

    @Test
    void everyKeyArrives() {
        DomainSpec read = read(with("'description': 'd', 'prior': {'box': 1}, 'pointing_origin': [0.1, 0.2, 0.3],"
                + "'shoulder': [1, 2, 3], 'tau': 0.9, 'tau_human': 0.8, 'handovers': 2, 'wrong_pick': 'terminal',"
                + "'ask': {'sets': 'attributes'}, 'understanding': {'pick_error': 0.2}, 'speech': {'surprise': 0.3},"
                + "'gesture': {'outliers': 0.1}, 'rewards': {'match_score': 'l1'}, 'acts': {'ask': {'duration': 9}}"));
        ObjectNode expected = DomainFiles.toJson(SPEC);
        expected.put("description", "d").put("tau", 0.9).put("tau_human", 0.8).put("handovers", 2)
                .put("wrong_pick", "terminal");
        expected.putObject("prior").put("box", 1.0);
        expected.putArray("pointing_origin").add(0.1).add(0.2).add(0.3);
        expected.putArray("shoulder").add(1.0).add(2.0).add(3.0);
        expected.withObjectProperty("ask").put("sets", "attributes");
        expected.withObjectProperty("understanding").put("pick_error", 0.2);
        expected.withObjectProperty("speech").put("surprise", 0.3);
        expected.withObjectProperty("gesture").put("outliers", 0.1);
        expected.withObjectProperty("rewards").put("match_score", "l1");
        expected.withObjectProperty("acts").withObjectProperty("ask").put("duration", 9.0);
        assertEquals(expected, DomainFiles.toJson(read));
        assertEquals(MatchScore.L1, read.rewards().matchScore());
    }

    @Test
    void aVariantMayAddActs() {
        DomainSpec read = read(with("'acts': {'nod': {'reward': -1, 'duration': 1, 'speech_rate': 0.1,"
                + "'gesture_rate': 0.2, 'answer_if_match': 0.3, 'answer_if_miss': 0.4}}"));
        assertEquals(new ActParameters(-1, 1, 0.1, 0.2, 0.3, 0.4), read.act("nod"));
        assertEquals(SPEC.act("ask"), read.act("ask"));
        assertEquals(read, DomainFiles.fromJson(DomainFiles.toJson(read), "x"));
    }

    @Test
    void anEditorMayBeToldTheSchema() {
        assertEquals(SPEC, read(with("'$schema': 'schema/domain.schema.json'")));
    }

    @Test
    void labelsMayBeGiven() {
        String text = BadDomains.GOOD.replace("'name': 'cup',", "'name': 'cup', 'label': 'my cup',");
        assertEquals("my cup", read(text).objects().get(0).label());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 200})
    void anyNumberOfObjectsLoads(int n) {
        List<TableObject> many = IntStream.range(0, n).mapToObj(i -> new TableObject("thing_" + i,
                new Vector3(0.1 * (i % 20), 0.5 + 0.1 * (i / 20), 0), Map.of("thing", 1.0, "w" + i, 2.0), null)).toList();
        DomainSpec spec = DomainSpec.of("many", many);
        DomainSpec read = read(RecordMapper.canonical(DomainFiles.toJson(spec)));
        assertEquals(spec, read);
        assertEquals(n, new HandoverDomain(read).start().size());
    }

    @Test
    void aFileInTheWayOfANameWins() throws IOException {
        Path file = Files.writeString(folder.resolve("kitchen-20"), BadDomains.quoted(BadDomains.GOOD));
        assertEquals("x", DomainFiles.read(file.toString()).name());
    }

    @Test
    void theHashDoesNotDependOnOrderOrDescription() {
        String hash = DomainFiles.hash(SPEC);
        assertTrue(hash.matches("[0-9a-f]{16}"), hash);
        assertEquals(hash, DomainFiles.hash(read("{'tau': 1.0, 'objects': [{'words': {'cup': 2, 'red': 1},"
                + "'position': [0, 0.6, 0], 'name': 'cup'}, " + BadDomains.BOX + "], 'description': 'd', 'name': 'x'}")));
        assertNotEquals(hash, DomainFiles.hash(SPEC.with(s -> s.name = "y")));
        assertNotEquals(hash, DomainFiles.hash(SPEC.with(s -> s.tau = Math.nextDown(1.0))));
        assertNotEquals(hash, DomainFiles.hash(SPEC.with(s -> s.objects = List.of(OBJECTS.get(1), OBJECTS.get(0)))));
    }

    @Test
    void whatIsHashedIsTheSameOnEveryJava() {
        assertEquals("{\"a\":{\"c\":1.0E-5,\"d\":0.01},\"b\":2.0E23}",
                RecordMapper.canonical(json("{'b': 2e23, 'a': {'d': 1e-2, 'c': 0.00001}}")),
                "Java 17's Double.toString would say 1.9999999999999998E23");
    }

    @Test
    void theLanguageOfTheComputerDoesNotMatter() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("tr"));
            assertEquals("terminal", RecordMapper.name(WrongPick.TERMINAL));
            assertEquals(SPEC, DomainFiles.fromJson(DomainFiles.toJson(SPEC), "x"));
        } finally {
            Locale.setDefault(before);
        }
    }

    private static DomainSpec read(String text) {
        return DomainFiles.fromJson(json(text), "x");
    }
}
