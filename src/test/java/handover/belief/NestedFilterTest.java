package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState.StateBelief;
import handover.domain.Act;
import handover.domain.AnyDomain;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.NestedBeliefDomain;
import handover.domain.Observation;
import handover.domain.PerceptionParameters;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** The filter where acts may be misperceived; that it is exact Bayes is rule 15 of the domain contract. */
class NestedFilterTest {
    private static final int ACTS = 6;

    private static DomainSpec two(double missed, double misread) {
        return DomainSpec.of("two", List.of(
                new TableObject("cup", new Vector3(-0.3, 0.6, 0), Map.of("cup", 1.0), null),
                new TableObject("can", new Vector3(0.3, 0.6, 0), Map.of("can", 1.0), null)))
                .with(s -> s.perception = new PerceptionParameters(missed, misread, 50));
    }

    private static Observation says(HandoverDomain domain, String text) {
        return new Observation(text.isEmpty() ? null : Speech.of(text, domain.vocabulary()), null, PickSignal.NONE);
    }

    private record Heard(Act act, Observation observation) {}

    /** Random acts, and what people of the domain do. */
    private static List<Heard> dialogue(HandoverDomain domain, RandomGenerator random) {
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        HandoverState s = domain.initialState(domain.spec().objects().get(0).name());
        List<Heard> all = new ArrayList<>();
        for (int k = 0; k < ACTS && !model.terminal(s); k++) {
            List<Act> acts = s.task().legalActs().stream().filter(m -> !m.isPick() || random.nextInt(4) == 0).map(m -> m.act()).toList();
            Act act = acts.get(random.nextInt(acts.size()));
            s = (HandoverState) model.sample(s, act).op;
            all.add(new Heard(act, senses.sample(s, act)));
        }
        return all;
    }

    private static List<HandoverBelief> follow(HandoverDomain domain, List<Heard> dialogue) {
        List<HandoverBelief> all = new ArrayList<>();
        HandoverBelief belief = HandoverBelief.initial(domain);
        for (Heard h : dialogue) {
            belief = belief.after(h.act).given(h.observation);
            all.add(belief);
        }
        return all;
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }

    /** With nothing misperceived it is the base filter to the last bit; and nothing happens suddenly on the way there. */
    @Property(tries = 150, seed = "71", edgeCases = EdgeCasesMode.NONE)
    void withoutMisperceptionItIsTheBaseFilter(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain base = new HandoverDomain(spec);
        HandoverDomain none = new NestedBeliefDomain(spec.with(s -> s.perception = new PerceptionParameters(0, 0, 3)));
        HandoverDomain hardly = new NestedBeliefDomain(spec.with(s -> s.perception = new PerceptionParameters(1e-16, 1e-16, 7)));
        List<Heard> dialogue = dialogue(base, random);
        List<HandoverBelief> right = follow(base, dialogue);
        List<HandoverBelief> same = follow(none, dialogue);
        List<HandoverBelief> close = follow(hardly, dialogue);
        for (int t = 0; t < right.size(); t++) {
            assertArrayEquals(right.get(t).probabilities(), same.get(t).probabilities(), 0, "b after " + dialogue.get(t));
            assertArrayEquals(right.get(t).human(), same.get(t).human(), 0, "h after " + dialogue.get(t));
            assertArrayEquals(right.get(t).probabilities(), close.get(t).probabilities(), 1e-9, "b, nearly, after " + dialogue.get(t));
            assertArrayEquals(right.get(t).human(), close.get(t).human(), 1e-9, "h, nearly, after " + dialogue.get(t));
            assertEquals(right.get(t).matchReward(), close.get(t).matchReward(), 1e-9, "match reward after " + dialogue.get(t));
        }
    }

    /**
     * ASK(cup), "yes": either it was heard, or ASK(can) was and the answer is an error, or, asked about the can, it is the can
     * that is wanted; who missed the question does not answer. r = 0.95, e = 0.01.
     */
    @Test
    void aYesMayBeToAnotherQuestion() {
        HandoverDomain domain = new HandoverDomain(two(0.1, 0.2));
        HandoverBelief b = HandoverBelief.initial(domain).after(Act.of("ASK", "cup")).given(says(domain, "yes"));
        double ifCup = 0.7 * 0.95 * 0.99 + 0.2 * 0.95 * 0.01;
        double ifCan = 0.7 * 0.95 * 0.01 + 0.2 * 0.95 * 0.99;
        assertArrayEquals(new double[] {ifCup / (ifCup + ifCan), ifCan / (ifCup + ifCan)}, b.probabilities(), 1e-12);
        double heardCup = (ifCup + ifCan) * 0.7 / 0.9;
        assertEquals(2, b.minds().size(), "nobody who missed it answers");
        Mind heard = b.minds().stream().max(Comparator.comparingDouble(Mind::weight)).orElseThrow();
        assertEquals(heardCup / (ifCup + ifCan), heard.weight(), 1e-12);
        assertTrue(heard.human()[0] > 0.5);
    }

    /** A "no" tells about both: given that the cup is wanted, it was probably the other question that was heard. */
    @Test
    void aNoTellsWhatWasPerceivedToo() {
        HandoverDomain domain = new HandoverDomain(two(0, 0.2));
        HandoverBelief b = HandoverBelief.initial(domain).after(Act.of("ASK", "cup")).given(says(domain, "no"));
        Mind misheard = b.minds().stream().filter(m -> m.human()[1] > 0.5).findFirst().orElseThrow();
        double ifCup = Math.exp(misheard.log()[0]) / b.probabilities()[0];
        double ifCan = Math.exp(misheard.log()[1]) / b.probabilities()[1];
        assertEquals(0.2 * 0.99 / (0.8 * 0.01 + 0.2 * 0.99), ifCup, 1e-12);
        assertEquals(0.2 * 0.01 / (0.8 * 0.99 + 0.2 * 0.01), ifCan, 1e-12);
    }

    /** Silence after a question, and then a "yes" while the robot waits: the question was heard after all. */
    @Test
    void whoMissedAQuestionDoesNotAnswerItLater() {
        HandoverDomain domain = new HandoverDomain(two(0.3, 0));
        HandoverBelief silent = HandoverBelief.initial(domain).after(Act.of("ASK", "cup")).given(says(domain, ""));
        double heard = 0.7 * 0.05;
        assertEquals(heard / (heard + 0.3), weightOfOpen(silent), 1e-12);
        HandoverBelief yes = silent.after(Act.WAIT).given(says(domain, "yes"));
        assertEquals(1, yes.minds().size());
        assertEquals(0.99, yes.probabilities()[0], 1e-12);
    }

    private static double weightOfOpen(HandoverBelief b) {
        return b.minds().stream().filter(m -> m.task().openReference() != null).mapToDouble(Mind::weight).sum();
    }

    /** Asking again is annoying to those who heard the first question only. */
    @Test
    void theStatesSayWhatIsPaid() {
        HandoverDomain domain = new HandoverDomain(two(0.3, 0.1));
        HandoverBelief b = HandoverBelief.initial(domain).after(Act.of("ASK", "cup"));
        double expected = 0;
        for (StateBelief s : b.nonZeroBeliefs()) {
            HandoverState state = (HandoverState) s.s;
            expected += s.belief * domain.matchReward(Simplex.vertex(2, state.wanted()), state.human(), 2);
            assertEquals(s.belief, b.belief(state), 1e-12);
        }
        assertEquals(expected, b.matchReward(), 1e-12);
        assertEquals(1, b.nonZeroBeliefs().stream().mapToDouble(s -> s.belief).sum(), 1e-12);
        assertEquals(6, b.nonZeroBeliefs().size());
    }

    /** Pieces in any order are the whole step, also if it is a step in which something else was perceived. */
    @Property(tries = 100, seed = "72", edgeCases = EdgeCasesMode.NONE)
    void eventsInAnyOrderAreTheWholeStep(@ForAll Random random) {
        HandoverDomain domain = DomainFiles.load("bowls-nested");
        List<Heard> dialogue = dialogue(domain, random);
        HandoverBelief belief = HandoverBelief.initial(domain);
        for (Heard h : dialogue) {
            HandoverBelief during = belief.after(h.act);
            belief = during.given(h.observation);
            if (h.observation.signal() != PickSignal.NONE || h.observation.speech() == null) {
                continue;
            }
            HandoverBelief first = h.observation.gesture() == null ? during : during.saw(h.observation.gesture());
            first = first.heard(h.observation.speech()).closed();
            HandoverBelief last = during.heard(h.observation.speech());
            last = (h.observation.gesture() == null ? last : last.saw(h.observation.gesture())).closed();
            for (HandoverBelief pieces : List.of(first, last)) {
                assertArrayEquals(belief.probabilities(), pieces.probabilities(), 1e-12, h.toString());
                assertArrayEquals(belief.human(), pieces.human(), 1e-12, h.toString());
            }
        }
    }

    /** Near minds put together change neither b nor E[beta] at that moment, and little later (analyze nested has the numbers). */
    @Test
    void fiftyMindsAreEnough() {
        DomainSpec spec = DomainFiles.read("bowls-nested");
        HandoverDomain fifty = DomainFiles.domain(spec);
        HandoverDomain all = DomainFiles.domain(spec.with(s -> s.perception = new PerceptionParameters(0.1, 0.1, 100_000)));
        double worst = 0;
        for (int k = 0; k < 40; k++) {
            List<Heard> dialogue = dialogue(fifty, new SplittableRandom(k));
            List<HandoverBelief> found = follow(fifty, dialogue);
            List<HandoverBelief> right = follow(all, dialogue);
            for (int t = 0; t < found.size(); t++) {
                assertTrue(found.get(t).minds().size() <= 50, "minds " + found.get(t).minds().size());
                worst = Math.max(worst, Simplex.l1(found.get(t).human(), right.get(t).human()));
                assertArrayEquals(right.get(t).probabilities(), found.get(t).probabilities(), 1e-3, "b");
            }
            HandoverBelief last = right.get(right.size() - 1);
            List<Mind> few = last.minds(5);
            assertTrue(few.size() <= 5);
            assertArrayEquals(last.probabilities(), sums(few, last.probabilities().length), 1e-9);
        }
        assertTrue(worst < 0.01, "E[beta] is off by " + worst);
    }

    private static double[] sums(List<Mind> minds, int n) {
        double[] b = new double[n];
        Arrays.setAll(b, i -> minds.stream().mapToDouble(m -> Math.exp(m.log()[i])).sum());
        return b;
    }

    /** Told what is wanted, the robot still does not know what was perceived. */
    @Test
    void revealing() {
        HandoverDomain domain = new HandoverDomain(two(0, 0.2));
        HandoverBelief b = HandoverBelief.initial(domain).after(Act.of("ASK", "cup")).given(says(domain, "no")).revealed(0);
        assertArrayEquals(new double[] {1, 0}, b.probabilities(), 0);
        Mind misheard = b.minds().stream().filter(m -> m.human()[1] > 0.5).findFirst().orElseThrow();
        assertEquals(0.2 * 0.99 / (0.8 * 0.01 + 0.2 * 0.99), misheard.weight(), 1e-12);
    }
}
