package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What the human may take an act for. */
class PerceptTest {
    /** At angles 0, 10, 25 and 90 degrees from straight on. */
    private static final HandoverDomain DOMAIN = domain(0.1, 0.2, 0, 10, 25, 90);

    private static HandoverDomain domain(double missed, double misread, double... degrees) {
        List<TableObject> objects = IntStream.range(0, degrees.length).mapToObj(i -> {
            double a = Math.toRadians(degrees[i]);
            return new TableObject("o" + i, new Vector3(Math.sin(a), Math.cos(a), 0.3), Map.of("w" + i, 1.0), null);
        }).toList();
        return new HandoverDomain(DomainSpec.of("x", objects)
                .with(s -> s.perception = new PerceptionParameters(missed, misread, 50)));
    }

    private static Map<String, Double> percepts(HandoverDomain domain, Act act) {
        Map<String, Double> all = new TreeMap<>();
        domain.start().percepts(domain.start().model(act)).forEach(p -> all.merge(p.act().toString(), p.probability(), Double::sum));
        return all;
    }

    @Test
    void aPointIsTakenForTheNearest() {
        assertEquals(Map.of("POINT(o1)", 0.7, "POINT(o0)", 0.2, "WAIT", 0.1), rounded(percepts(DOMAIN, Act.of("POINT", "o1"))));
        assertEquals(Map.of("LOOK(o2)", 0.7, "LOOK(o1)", 0.2, "WAIT", 0.1), rounded(percepts(DOMAIN, Act.of("LOOK", "o2"))));
    }

    @Test
    void theNearestShareIt() {
        HandoverDomain even = domain(0, 0.2, -30, 0, 30);
        assertEquals(Map.of("POINT(o1)", 0.8, "POINT(o0)", 0.1, "POINT(o2)", 0.1), rounded(percepts(even, Act.of("POINT", "o1"))));
    }

    @Test
    void picksAndWaitsAreIndisputable() {
        assertEquals(Map.of("WAIT", 1.0), percepts(DOMAIN, Act.WAIT));
        assertEquals(Map.of("PICK(o1)", 1.0), percepts(DOMAIN, Act.of("PICK", "o1")));
    }

    @Test
    void aloneThereIsNothingElseToRead() {
        assertEquals(Map.of("ASK(o0)", 0.9, "WAIT", 0.1), rounded(percepts(domain(0.1, 0.2, 0), Act.of("ASK", "o0"))));
    }

    @Test
    void exactIfNothingIsMisperceived() {
        assertTrue(domain(0, 0, 0, 10).start().perceivedExactly());
        assertEquals(false, DOMAIN.start().perceivedExactly());
        assertTrue(new HandoverDomain(DomainSpec.of("x", DOMAIN.spec().objects())).start().perceivedExactly(), "the default");
    }

    @Test
    void parametersAreChecked() {
        assertEquals("misread: expected at most 1 - missed = 0.25, got 0.5",
                assertThrows(InvalidParameterException.class, () -> new PerceptionParameters(0.75, 0.5, 50)).getMessage());
        assertThrows(InvalidParameterException.class, () -> new PerceptionParameters(-0.1, 0, 50));
        assertThrows(InvalidParameterException.class, () -> new PerceptionParameters(0, 0, 0));
    }

    @Test
    void theVariantComesWithDefaults() {
        DomainSpec spec = NestedBeliefDomain.defaults(DomainSpec.of("x", DOMAIN.spec().objects()));
        assertEquals(0.1, spec.perception().missed());
        assertEquals(0.1, spec.perception().misread());
    }

    /** Answers on average: 0.7 heard, 0.2 about the neighbour, 0.1 not at all. */
    @Test
    void answersOnAverage() {
        Task start = DOMAIN.task(DOMAIN.start());
        int ask = DOMAIN.start().model(Act.of("ASK", "o1")).index();
        double match = 0.95 * 0.99;
        double error = 0.95 * 0.01;
        String other = percepts(DOMAIN, Act.of("ASK", "o1")).keySet().stream().filter(a -> !a.equals("ASK(o1)") && !a.equals("WAIT"))
                .findFirst().orElseThrow();
        int taken = DOMAIN.start().indexOf(other.substring(4, other.length() - 1));
        long alike = DOMAIN.start().percepts(DOMAIN.start().acts().get(ask)).size() - 2;
        double[] yes = start.expectedAnswers(ask).yes();
        assertEquals(0.7 * match + 0.2 * error, yes[1], 1e-12);
        assertEquals(0.7 * error + 0.2 / alike * match + 0.2 * (1 - 1.0 / alike) * error, yes[taken], 1e-12);
    }

    private static Map<String, Double> rounded(Map<String, Double> p) {
        Map<String, Double> r = new TreeMap<>(p);
        r.replaceAll((k, v) -> Math.round(v * 1e9) / 1e9);
        return r;
    }
}
