package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.math.Simplex;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What a table answers, and when it leaves the answer to somebody else. */
class NearestPolicyTest {
    private static final Policy FALLBACK = (belief, deadline, random) -> Decision.of(Act.WAIT);
    private final HandoverDomain domain = Mirrored.domain();
    private final PolicyTable.Builder builder = new PolicyTable.Builder(BeliefMetric.DEFAULT, 1000);
    private final BeliefSpace space = new BeliefSpace(BeliefMetric.DEFAULT);

    @Test
    void theNearestDecides() {
        put(at(0.8, 0.1, 0.1), "PICK", "left_cup");
        put(at(0.1, 0.8, 0.1), "PICK", "bowl");
        assertEquals(Act.of("PICK", "bowl"), decide(1, 9, at(0.2, 0.7, 0.1)).act());
        assertEquals(Act.of("PICK", "left_cup"), decide(1, 9, at(0.7, 0.2, 0.1)).act());
        assertEquals("", decide(1, 9, at(0.7, 0.2, 0.1)).note());
        assertEquals(3.0, decide(1, 9, at(0.7, 0.2, 0.1)).values().get(Act.of("PICK", "left_cup")));
    }

    /** One belief serves all permutations that make no difference: the cups are swapped, and so is the answer. */
    @Test
    void aStoredBeliefServesItsMirrorImage() {
        put(at(0.8, 0.1, 0.1), "PICK", "left_cup");
        Decision mirrored = decide(1, 1e-3, at(0.1, 0.1, 0.8));
        assertEquals(Act.of("PICK", "right_cup"), mirrored.act());
        assertEquals("", mirrored.note());
        assertEquals(3.0, mirrored.values().get(Act.of("PICK", "right_cup")));
        assertEquals(1.0, mirrored.values().get(Act.of("PICK", "left_cup")));
        assertTrue(fallsBack(decide(1, 1e-3, at(0.1, 0.8, 0.1))), "the bowl cannot be swapped");
    }

    @Test
    void anOpenQuestionIsMirroredToo() {
        HandoverBelief left = HandoverBelief.initial(domain).after(Act.of("ASK", "left_cup")).given(Observation.NOTHING);
        HandoverBelief right = HandoverBelief.initial(domain).after(Act.of("ASK", "right_cup")).given(Observation.NOTHING);
        put(left, "POINT", "left_cup");
        assertEquals(Act.of("POINT", "right_cup"), decide(1, 1e-3, right).act());
        assertEquals(Act.of("POINT", "left_cup"), decide(1, 1e-3, left).act());
        assertTrue(fallsBack(decide(1, 9, HandoverBelief.initial(domain))), "nothing is stored where no question is open");
        assertTrue(fallsBack(decide(1, 9, HandoverBelief.initial(domain).after(Act.of("ASK", "bowl")).given(Observation.NOTHING))));
    }

    /** An answered question does not matter any more, and neither does the last pick signal. */
    @Test
    void whatNoLongerMattersIsNotCompared() {
        put(HandoverBelief.initial(domain), "ASK", "bowl");
        Speech no = Speech.of(new Utterance(Answer.NO, List.of(), List.of(), List.of()));
        HandoverBelief answered = HandoverBelief.initial(domain).after(Act.of("ASK", "bowl"))
                .given(new Observation(no, null, PickSignal.NONE));
        assertFalse(fallsBack(decide(1, 9, answered)));
        HandoverBelief rejected = HandoverBelief.initial(domain).after(Act.of("PICK", "bowl"))
                .given(new Observation(null, null, PickSignal.REJECTED));
        assertFalse(fallsBack(decide(1, 9, rejected)));
    }

    @Test
    void neighboursVoteByTheirValues() {
        put(at(0.8, 0.1, 0.1), Map.of(Act.of("PICK", "left_cup"), 10.0, Act.WAIT, 0.0));
        put(at(0.7, 0.2, 0.1), Map.of(Act.of("PICK", "left_cup"), -30.0, Act.WAIT, 1.0));
        put(at(0.7, 0.1, 0.2), Map.of(Act.of("PICK", "left_cup"), -30.0, Act.WAIT, 1.0));
        assertEquals(Act.of("PICK", "left_cup"), decide(1, 9, at(0.79, 0.105, 0.105)).act());
        assertEquals(Act.of("PICK", "left_cup"), decide(3, 9, at(0.8, 0.1, 0.1)).act(), "the belief itself has nearly all the weight");
        assertEquals(Act.WAIT, decide(3, 9, at(0.73, 0.14, 0.13)).act());
    }

    @Test
    void aTeacherWithoutValuesIsFollowedByMajority() {
        builder.add(space.stored(at(0.8, 0.1, 0.1), Decision.of(Act.of("PICK", "left_cup"))));
        builder.add(space.stored(at(0.7, 0.1, 0.2), Decision.of(Act.of("ASK", "bowl"))));
        builder.add(space.stored(at(0.7, 0.2, 0.1), Decision.of(Act.of("ASK", "bowl"))));
        assertEquals(Act.of("PICK", "left_cup"), decide(1, 9, at(0.8, 0.1, 0.1)).act());
        assertEquals(Act.of("ASK", "bowl"), decide(3, 9, at(0.74, 0.13, 0.13)).act());
        assertTrue(decide(1, 9, at(0.8, 0.1, 0.1)).values().isEmpty());
    }

    @Test
    void aBeliefMetAgainIsStoredOnceWithTheMean() {
        assertTrue(put(at(0.8, 0.1, 0.1), Map.of(Act.of("PICK", "left_cup"), 10.0, Act.WAIT, 4.0)));
        assertFalse(put(at(0.8, 0.1, 0.1), Map.of(Act.of("PICK", "left_cup"), -4.0, Act.WAIT, 4.0)));
        assertEquals(1, builder.size());
        Decision d = decide(1, 9, at(0.8, 0.1, 0.1));
        assertEquals(3.0, d.values().get(Act.of("PICK", "left_cup")));
        assertEquals(Act.WAIT, d.act());
    }

    @Test
    void beyondTheRadiusTheFallbackDecidesAndSaysSo() {
        put(at(0.8, 0.1, 0.1), "PICK", "left_cup");
        HandoverBelief near = at(0.79, 0.11, 0.1);
        assertFalse(fallsBack(decide(1, 0.1, near)));
        HandoverBelief novel = near.after(Act.WAIT).given(new Observation(
                Speech.of("bowl not the red cup, the blue bowl bowl", domain.vocabulary()), null, PickSignal.NONE));
        Decision d = decide(1, 0.1, novel);
        assertEquals(Act.WAIT, d.act());
        assertEquals("fallback to waiting: no stored belief within 0.1", d.note());
    }

    /** Moved, removed, added: what is stored does not hold any more. Put back: it does. */
    @Test
    void whatIsStaleIsNotUsed() {
        put(at(0.8, 0.1, 0.1), "PICK", "left_cup");
        List<TableObject> objects = domain.start().objects();
        TableObject moved = objects.get(2).at(new Vector3(0.2, 0.6, 0.001));
        assertTrue(stale(List.of(objects.get(0), objects.get(1), moved)));
        assertTrue(stale(objects.subList(0, 2)));
        List<TableObject> more = new ArrayList<>(objects);
        more.add(new TableObject("can", new Vector3(0.4, 0.6, 0), Map.of("red", 1.0), null));
        assertTrue(stale(more));
        assertTrue(stale(List.of(objects.get(2), objects.get(1), objects.get(0))), "values are stored in table order");
        List<TableObject> back = List.of(objects.get(0), objects.get(1), moved.at(objects.get(2).position()));
        assertFalse(stale(back));
    }

    /** With several handovers the rest of the table is a part of its own, which holds by itself. */
    @Test
    void partsHoldOneByOne() {
        DomainSpec two = Mirrored.spec().with(s -> s.handovers = 2);
        HandoverDomain on = new HandoverDomain(two);
        HandoverBelief start = HandoverBelief.initial(on);
        HandoverBelief later = start.after(Act.of("PICK", "bowl")).given(new Observation(null, null, PickSignal.ACCEPTED));
        builder.add(space.stored(later, Decision.of(Act.of("ASK", "left_cup"))));
        NearestPolicy policy = new NearestPolicy(builder.build(), 1, 9, FALLBACK, "waiting");
        assertTrue(fallsBack(policy.decide(start, Deadline.NONE, new SplittableRandom(1))));
        assertFalse(fallsBack(policy.decide(later, Deadline.NONE, new SplittableRandom(1))));
    }

    private boolean stale(List<TableObject> objects) {
        Scene scene = domain.scene(objects);
        double[] uniform = Simplex.uniform(objects.size());
        double[] b = Simplex.uniform(objects.size());
        return fallsBack(decide(1, 9, HandoverBelief.of(domain.task(scene), b, uniform)));
    }

    private HandoverBelief at(double... b) {
        return HandoverBelief.of(domain.task(domain.start()), b, Simplex.uniform(3));
    }

    /** With symmetries the nearest are those of all images of the query, each stored belief once, where it is nearest. */
    @Test
    void imagesAreSearchedExactly() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 200; i++) {
            put(at(distribution(random)), "PICK", "bowl");
        }
        PolicyPart part = builder.build().parts().get(0);
        List<Symmetry> images = Symmetries.of(domain.start());
        for (int i = 0; i < 300; i++) {
            HandoverBelief query = at(distribution(random));
            Neighbours nearest = new Neighbours(5, part.ordinals(), Float.POSITIVE_INFINITY);
            float[] best = new float[part.size()];
            Arrays.fill(best, Float.POSITIVE_INFINITY);
            for (int s = 0; s < images.size(); s++) {
                float[] x = new float[6];
                BeliefMetric.DEFAULT.coordinates(query, images.get(s).objects(), x);
                nearest.under(s);
                part.tree().search(x, nearest);
                for (int r = 0; r < best.length; r++) {
                    best[r] = Math.min(best[r], BeliefMetric.squared(x, 0, part.coordinates(), 6 * r, 6, Float.POSITIVE_INFINITY));
                }
            }
            Arrays.sort(best);
            for (int k = 0; k < 5; k++) {
                assertEquals(Math.sqrt(best[k]), nearest.distance(k));
            }
        }
    }

    private static double[] distribution(SplittableRandom random) {
        double[] p = random.doubles(3).toArray();
        Simplex.normalise(p, 3);
        return p;
    }

    /** Stores a belief at which an act is worth 3 and all others 1. */
    private void put(HandoverBelief belief, String verb, String object) {
        Map<Act, Double> values = new LinkedHashMap<>();
        belief.scene().acts().forEach(m -> values.put(m.act(), 1.0));
        values.put(Act.of(verb, object), 3.0);
        put(belief, values);
    }

    private boolean put(HandoverBelief belief, Map<Act, Double> values) {
        Act best = values.entrySet().stream().max(Map.Entry.comparingByValue()).orElseThrow().getKey();
        return builder.add(space.stored(belief, new Decision(best, values, 1, 1, true)));
    }

    private Decision decide(int k, double radius, HandoverBelief belief) {
        return new NearestPolicy(builder.build(), k, radius, FALLBACK, "waiting").decide(belief, Deadline.NONE, new SplittableRandom(1));
    }

    private static boolean fallsBack(Decision d) {
        return d.note().startsWith("fallback to waiting: ");
    }
}
