package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import handover.math.GoodnessOfFit;
import handover.math.Vector3;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.random.RandomGenerator;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** MODEL 4: the likelihood of whole observations against the oracle, and the sampler against the likelihood. */
class ObservationTest {
    private static final int DRAWS = 40_000;
    private static final double FALSE_ALARM = 1e-6;
    /** V = {blue, red}; the labels are in no vocabulary. */
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 2.0), null),
            new TableObject("b", new Vector3(0, 0.6, 0), Map.of("blue", 1.0), null),
            new TableObject("c", new Vector3(0.3, 0.6, 0), Map.of("red", 1.0, "blue", 3.0), null));

    @Property(tries = 250, seed = "55", edgeCases = EdgeCasesMode.NONE)
    void likelihoodsAreThoseOfTheText(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        int n = oracle.n();
        int i = random.nextInt(n);
        Act act = AnyDomain.oneOf(domain.start().acts().stream().filter(m -> !m.isPick()).toList(), random).act();
        Act open = act.equals(Act.WAIT) ? null : act;
        double[] h = AnyDomain.simplex(n, random);
        Task during = domain.task(domain.start()).effect(act).during();
        HandoverObservationFunction function = new HandoverObservationFunction(domain, random);
        for (Answer answer : open == null ? new Answer[] {Answer.NONE} : Answer.values()) {
            HandoverState s = new HandoverState(i, during.answered(answer), h);
            for (int k = 0; k < 4; k++) {
                List<String> words = k == 0 ? List.of() : AnyDomain.someWords(domain, 3, random);
                List<String> not = k < 2 ? List.of() : AnyDomain.someWords(domain, 2, random);
                Gesture gesture = k < 3 ? null : HumanModel.sampleGesture(domain.start(), random.nextInt(n), random);
                double rate = oracle.contentRate(act, h[i]);
                double p = words.isEmpty() ? 1 - rate : rate * spec.speech().wordCounts().get(words.size() - 1);
                for (String w : words) {
                    p *= oracle.word(w, i, open);
                }
                for (String w : not) {
                    p *= oracle.negated(w, i);
                }
                p *= gesture == null ? 0.7 : 0.3 * oracle.gesture(gesture, i);
                Speech said = Speech.of(new Utterance(answer, words, not, List.of()));
                assertEquals(p, function.probability(new Observation(said, gesture, PickSignal.NONE), s, act),
                        1e-9 * Math.max(1, p), () -> said + " after " + act);
            }
        }
    }

    @Test
    void anNBestListIsAMixture() {
        HandoverDomain domain = domain(0.04, 0.05);
        HandoverObservationFunction f = new HandoverObservationFunction(domain, new SplittableRandom(1));
        HandoverState s = state(domain, Act.of("ASK", "a"), Answer.YES);
        Utterance yesRed = Utterance.parse("yes red", domain.vocabulary());
        Utterance noBlue = Utterance.parse("no blue", domain.vocabulary());
        Utterance yesBlue = Utterance.parse("yes blue blue", domain.vocabulary());
        Speech list = new Speech(List.of(new Speech.Alternative(yesRed, 2), new Speech.Alternative(noBlue, 1),
                new Speech.Alternative(yesBlue, 1)));
        double expected = 0.5 * p(f, s, Speech.of(yesRed)) + 0.25 * p(f, s, Speech.of(yesBlue));
        assertEquals(expected, p(f, s, list), 1e-12, "the answer of the state is yes, so \"no blue\" adds nothing");
        Speech unsure = new Speech(List.of(new Speech.Alternative(yesRed, 0), new Speech.Alternative(yesBlue, 0)));
        assertEquals((p(f, s, Speech.of(yesRed)) + p(f, s, Speech.of(yesBlue))) / 2, p(f, s, unsure), 1e-12,
                "without confidences all count the same");
    }

    private static double p(HandoverObservationFunction f, HandoverState s, Speech speech) {
        return f.probability(new Observation(speech, null, PickSignal.NONE), s, Act.of("ASK", "a"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"WAIT", "ASK", "POINT", "LOOK"})
    void theSamplerDrawsFromTheLikelihood(String verb) {
        HandoverDomain domain = domain(0.04, 0.05);
        Act act = verb.equals("WAIT") ? Act.WAIT : Act.of(verb, "a");
        for (Answer answer : verb.equals("WAIT") ? new Answer[] {Answer.NONE} : Answer.values()) {
            HandoverState s = state(domain, act, answer);
            HandoverObservationFunction f = new HandoverObservationFunction(domain, new SplittableRandom(55));
            Map<String, Double> expected = new TreeMap<>();
            wordLists("", 3, words -> List.of(true, false).forEach(points -> {
                Speech said = Speech.of(Utterance.parse(answerWord(answer) + words, domain.vocabulary()));
                // Without a gesture the likelihood holds 1 - P(gesture) = .7; with one there is .3 in its place.
                double p = f.probability(new Observation(said, null, PickSignal.NONE), s, act) / 0.7;
                expected.put(words + points, p * (points ? 0.3 : 0.7));
            }));
            Map<String, Long> counts = new HashMap<>();
            for (int k = 0; k < DRAWS; k++) {
                Observation o = f.sample(s, act);
                Utterance said = o.speech() == null ? Utterance.SILENCE : o.speech().alternatives().get(0).utterance();
                assertEquals(answer, said.answer(), "the answer that the state holds");
                String words = said.content().stream().reduce("", (a, w) -> a + " " + w);
                counts.merge(words + (o.gesture() != null), 1L, Long::sum);
            }
            GoodnessOfFit.assertFits("said after " + act + ", " + answer, counts, expected, FALSE_ALARM);
        }
    }

    private static String answerWord(Answer answer) {
        return answer == Answer.YES ? "yes" : answer == Answer.NO ? "no" : "";
    }

    private static void wordLists(String said, int more, java.util.function.Consumer<String> sink) {
        sink.accept(said);
        for (String w : more == 0 ? List.<String>of() : List.of("red", "blue")) {
            wordLists(said + " " + w, more - 1, sink);
        }
    }

    @Test
    void gesturesAreDrawnAroundTheArm() {
        // The density of the angle theta to the wanted object is 2 pi sin(theta) f(theta); bins of 1/20 pi.
        for (double v : new double[] {0.001, 0.04, 1, 5}) {
            HandoverDomain domain = domain(v, 0.1);
            ModelOracle oracle = new ModelOracle(domain.spec(), OBJECTS);
            RandomGenerator random = new SplittableRandom(56);
            Vector3 shoulder = domain.spec().shoulder();
            long[] counts = new long[20];
            for (int k = 0; k < DRAWS; k++) {
                Gesture g = HumanModel.sampleGesture(domain.start(), 1, random);
                assertEquals(shoulder, g.shoulder());
                double theta = PointingOracle.angle(shoulder, shoulder.plus(g.direction()), OBJECTS.get(1).position());
                counts[(int) Math.min(19, theta / Math.PI * 20)]++;
            }
            double[] expected = new double[20];
            double[] arm = polar(shoulder, OBJECTS.get(1).position());
            for (int k = 0; k < 20_000; k++) {
                double theta = (k + 0.5) * Math.PI / 20_000;
                // A direction at angle theta from the arm, turned in the vertical plane of the arm.
                Vector3 d = new Vector3(Math.sin(arm[0] + theta) * Math.cos(arm[1]),
                        Math.sin(arm[0] + theta) * Math.sin(arm[1]), Math.cos(arm[0] + theta));
                expected[k / 1000] += 2 * Math.PI * Math.sin(theta) * oracle.gesture(new Gesture(shoulder, d), 1)
                        * Math.PI / 20_000;
            }
            GoodnessOfFit.assertFits("angles for v = " + v, counts, expected, FALSE_ALARM);
        }
    }

    /** Polar and azimuthal angle of the direction from {@code from} to {@code to}. */
    private static double[] polar(Vector3 from, Vector3 to) {
        Vector3 d = to.minus(from);
        return new double[] {Math.acos(d.z() / d.norm()), Math.atan2(d.y(), d.x())};
    }

    @Test
    void theSignalIsShownAndAnEndIsSilent() {
        HandoverDomain domain = domain(0.04, 0.05);
        Act pick = Act.of("PICK", "a");
        HandoverModel model = new HandoverModel(domain, new Random(1));
        HandoverState end = (HandoverState) model.sample(domain.initialState("a"), pick).op;
        HandoverObservationFunction f = new HandoverObservationFunction(domain, new Random(2));
        Observation o = f.sample(end, pick);
        assertEquals(PickSignal.ACCEPTED, o.signal());
        assertNull(o.speech());
        assertEquals(1, f.probability(o, end, pick), 0);
        assertEquals(0, f.probability(Observation.NOTHING, end, pick), 0, "the signal does not fit");
    }

    private static HandoverDomain domain(double v, double outliers) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> {
            s.gesture = new GestureParameters(v, outliers);
            s.speech = new SpeechParameters(0.2, 0.05, 0.5, 0.3, 0.01, List.of(0.5, 0.3, 0.2));
        }));
    }

    private static HandoverState state(HandoverDomain domain, Act act, Answer answer) {
        Task during = domain.task(domain.start()).effect(act).during();
        return new HandoverState(2, during.answered(answer), new double[] {0.5, 0.3, 0.2});
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
