package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.AnyDomain;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.HumanModel;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.Utterance;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** MODEL 4.4: the filter against Bayes' rule by enumeration and against the oracle, over random sequences. */
class FilterTest {
    private static final double CLOSE = 1e-9;
    private static final int STEPS = 10;

    @Property(tries = 400, seed = "61", edgeCases = EdgeCasesMode.NONE)
    void theBeliefIsBayes(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        double[] prior = AnyDomain.simplex(domain.start().size(), random);
        HandoverBelief belief = HandoverBelief.of(domain.task(domain.start()), prior, uniform(prior.length));
        FilterOracle oracle = new FilterOracle(spec, prior);
        for (int t = 0; t < STEPS && !belief.task().done(); t++) {
            Act act = act(belief, random);
            // What is wanted is drawn anew from b, because made-up observations may have excluded what was wanted before.
            HandoverState s = new HandoverState(draw(belief.probabilities(), random), belief.task(), belief.human());
            HandoverState next = (HandoverState) new HandoverModel(domain, random).sample(s, act).op;
            Observation o = observation(domain, next, act, random);
            HandoverBelief after = belief.after(act).given(o);
            double[] joint = BruteForce.joint(belief, act, o, after.probabilities().length);
            boolean informative = oracle.step(act, o);
            String step = "step " + t + ", " + act + ", " + o;
            boolean empty = after.probabilities().length == 0;
            assertEquals(informative || empty, Arrays.stream(joint).sum() > 0 || empty,
                    () -> "oracle and enumeration differ: " + step);
            if (empty || !informative) {
                assertEquals(!empty, after.uninformative(), () -> "uninformative: " + step);
                return;
            }
            assertArrayEquals(BruteForce.normalised(joint), after.probabilities(), CLOSE, () -> "enumeration: " + step);
            assertArrayEquals(oracle.b, after.probabilities(), CLOSE, () -> "oracle: " + step);
            assertArrayEquals(oracle.h, after.human(), CLOSE, () -> "h: " + step);
            assertEquals(false, after.uninformative(), () -> "uninformative: " + step);
            belief = after;
        }
    }

    /** Any legal act; picks only now and then, so that episodes last. */
    private static Act act(HandoverBelief belief, Random random) {
        List<ActModel> talk = belief.task().legalActs().stream().filter(m -> !m.isPick()).toList();
        return AnyDomain.oneOf(random.nextInt(5) == 0 ? belief.task().legalActs() : talk, random).act();
    }

    /** What a human in this state may say and show, or anything else that can be said and shown. */
    private static Observation observation(HandoverDomain domain, HandoverState s, Act act, Random random) {
        Observation natural = new HandoverObservationFunction(domain, random).sample(s, act);
        if (s.task().done() || random.nextBoolean()) {
            return natural;
        }
        List<Speech.Alternative> list = new ArrayList<>();
        int words = random.nextInt(4);
        for (int k = 1 + random.nextInt(3); k > 0; k--) {
            list.add(new Speech.Alternative(utterance(domain, s, words, random), random.nextInt(4) * 0.5));
        }
        Gesture gesture = random.nextBoolean() ? null
                : HumanModel.sampleGesture(s.task().scene(), random.nextInt(s.human().length), random);
        return new Observation(random.nextInt(5) == 0 ? null : new Speech(list), gesture, s.task().signal());
    }

    /** So many words in all alternatives of a list; {@link NBestTest} has lists of utterances of different length. */
    private static Utterance utterance(HandoverDomain domain, HandoverState s, int words, Random random) {
        boolean answerable = s.task().signal() == PickSignal.NONE && s.task().reference() != null;
        return new Utterance(answerable ? Answer.values()[random.nextInt(3)] : Answer.NONE,
                AnyDomain.words(domain, words, random),
                AnyDomain.words(domain, Math.max(0, random.nextInt(5) - 2), random),
                random.nextBoolean() ? List.of() : List.of("um"));
    }

    private static int draw(double[] p, Random random) {
        double u = random.nextDouble();
        int i = 0;
        while (i < p.length - 1 && (p[i] == 0 || (u -= p[i]) >= 0)) {
            i++;
        }
        return i;
    }

    private static double[] uniform(int n) {
        double[] p = new double[n];
        Arrays.fill(p, 1.0 / n);
        return p;
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
