package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.AskSets;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What comes with the toolkit loads, is valid for an editor, and has the objects of MODEL section 10. */
class ShippedFilesTest {
    private static final Path FOLDER = Path.of("domains");
    private static final Path HUMANS = FOLDER.resolve("humans");
    private static final Schema DOMAIN = Schema.of("domain");
    private static final Schema HUMAN = Schema.of("human");

    static List<Path> domains() throws IOException {
        return jsonFiles(FOLDER);
    }

    static List<Path> humans() throws IOException {
        return jsonFiles(HUMANS);
    }

    private static List<Path> jsonFiles(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(f -> f.toString().endsWith(".json")).sorted().toList();
        }
    }

    @ParameterizedTest
    @MethodSource("domains")
    void domainsLoadAndAreValid(Path file) throws IOException {
        assertEquals(Set.of(), DOMAIN.faults(JsonText.parse(Files.readAllBytes(file), "x")));
        DomainSpec spec = DomainFiles.read(file.toString());
        assertEquals(spec.name() + ".json", file.getFileName().toString());
        assertEquals(spec, DomainFiles.read(spec.name()));
        assertEquals(spec.objects().size(), new HandoverDomain(spec).start().size());
    }

    @ParameterizedTest
    @MethodSource("humans")
    void humansLoadForEveryDomainAndAreValid(Path file) throws IOException {
        assertEquals(Set.of(), HUMAN.faults(JsonText.parse(Files.readAllBytes(file), "x")));
        for (Path domain : domains()) {
            DomainSpec planner = DomainFiles.read(domain.toString());
            assertNotEquals(DomainFiles.hash(planner), DomainFiles.hash(DomainFiles.readHuman(planner, file)));
        }
    }

    @Test
    void domainsAreOnTheClassPath() throws IOException {
        for (Path file : domains()) {
            byte[] shipped = ShippedFilesTest.class.getResourceAsStream("/domains/" + file.getFileName()).readAllBytes();
            assertEquals(Files.readString(file), new String(shipped, StandardCharsets.UTF_8));
        }
    }

    @Test
    void theTableLinesAreSeenFromTheRobot() {
        TableObject cylinder = DomainFiles.read("table-line-6").objects().get(0);
        assertEquals(new TableObject("blue_cylinder", new Vector3(0.66, 0.5085, -0.116),
                Map.of("blue", 1.0, "turquoise", 1.0, "cylinder", 1.0), "blue cylinder"), cylinder);
        DomainSpec five = DomainFiles.read("table-line-5");
        assertEquals(new Vector3(-0.348, 0.955, -0.172), five.objects().get(4).position());
        assertEquals(0.02, five.understanding().sigmaPoint());
    }

    @Test
    void theBowlsAndSpoonsCountWordsAsIn2016() {
        List<TableObject> objects = DomainFiles.read("bowls-and-spoons").objects();
        assertEquals(List.of(53.0, 60.0, 40.0, 34.0), objects.stream()
                .map(o -> o.words().values().stream().mapToDouble(c -> c).sum()).toList());
        assertEquals(14, objects.get(2).count("spoon"));
    }

    @Test
    void theKitchenSharesItsWords() {
        DomainSpec kitchen = DomainFiles.read("kitchen-20");
        assertEquals(20, kitchen.objects().size());
        assertEquals(AskSets.ATTRIBUTES, kitchen.ask().sets());
        for (TableObject o : kitchen.objects()) {
            long shared = o.words().keySet().stream().filter(
                    w -> kitchen.objects().stream().filter(other -> other.count(w) > 0).count() > 1).count();
            assertTrue(2 * shared > o.words().size(), o.name());
            assertTrue(kitchen.objects().stream().allMatch(other -> other == o
                    || other.position().minus(o.position()).norm() >= 0.12), o.name());
        }
    }
}
