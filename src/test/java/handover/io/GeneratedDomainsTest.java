package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.IncrementalPickDomain;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables of any size. */
class GeneratedDomainsTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6, 10, 20, 50, 100, 200})
    void thingsOnATable(int n) {
        DomainSpec spec = DomainFiles.read("generated-" + n);
        assertEquals(n, spec.objects().size());
        assertEquals(spec, DomainFiles.read("generated-" + n), "the same number, the same table");
        assertEquals(spec, DomainFiles.fromJson(DomainFiles.toJson(spec), "x"), "it can be written to a file");
        double closest = Double.POSITIVE_INFINITY;
        for (TableObject o : spec.objects()) {
            Vector3 p = o.position();
            assertTrue(Math.abs(p.x()) <= 0.6 && p.y() >= 0.45 && p.y() <= 0.9 && p.z() == 0, o.toString());
            assertEquals(4, o.words().size(), "colour, kind, material and size of " + o);
            for (TableObject other : spec.objects()) {
                closest = other == o ? closest : Math.min(closest, p.minus(other.position()).norm());
            }
        }
        assertTrue(closest > 0.02, "things do not lie in each other: " + closest);
    }

    /** As on the kitchen table, of which 8 of 10 words fit several things, and a word fits 3 of 20 on the average. */
    @ParameterizedTest
    @CsvSource({"20, 0.6, 6", "100, 0.9, 30"})
    void wordsAreShared(int n, double share, int most) {
        Map<String, Long> uses = DomainFiles.read("generated-" + n).objects().stream().flatMap(o -> o.words().keySet().stream())
                .collect(Collectors.groupingBy(w -> w, Collectors.counting()));
        long shared = uses.values().stream().filter(k -> k > 1).count();
        assertTrue(shared >= share * uses.size(), uses.toString());
        assertTrue(uses.values().stream().allMatch(k -> k <= most), uses.toString());
    }

    @Test
    void variantsByName() {
        HandoverDomain domain = DomainFiles.load("generated-5-incremental");
        assertEquals(IncrementalPickDomain.class, domain.getClass());
        assertEquals(0.3, domain.spec().speech().surprise(), "with the variant's defaults");
        assertEquals(DomainFiles.read("generated-5").objects(), domain.spec().objects(), "the same table");
        assertEquals("base", DomainFiles.read("generated-5-base").variant());
    }

    @Test
    void everythingThatSharesAWordMayBeAskedAbout() {
        List<String> asks = DomainFiles.load("generated-20").start().acts().stream().filter(a -> a.act().verb().equals("ASK"))
                .map(a -> a.say()).toList();
        assertTrue(asks.contains("metal"), asks.toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            generated-0 | generated-0: expected from 1 to 200 objects
            generated-201-base | generated-201-base: expected from 1 to 200 objects
            generated-5-quick | generated-5-quick: variant: expected base, communicated, incremental, incremental_communicated, nested or
            generated-x | generated-x: there is no such file
            """)
    void whatCannotBeMeantIsSaid(String name, String message) {
        String got = assertThrows(DomainFileException.class, () -> DomainFiles.read(name)).getMessage();
        assertTrue(got.startsWith(message), got);
    }
}
