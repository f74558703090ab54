package handover.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.PerceptionParameters;
import handover.domain.PickParameters;
import handover.domain.PickSignal;
import handover.domain.Rewards;
import handover.domain.Speech;
import handover.domain.SpeechParameters;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The search over wish and mind together. */
class NestedSearchTest {
    /** Every kind of increment, surprise, contrast, moving wishes, several handovers, belief-dependent rewards. */
    static Stream<DomainSpec> specs() {
        DomainSpec bowls = DomainFiles.read("bowls-and-spoons");
        return Stream.of(bowls, DomainFiles.read("table-line-6").with(s -> s.handovers = 2),
                DomainFiles.read("bowls-incremental").with(s -> s.pick = new PickParameters(2, 0.7)),
                DomainFiles.read("bowls-communicated"),
                bowls.with(s -> {
                    s.tau = 0.9;
                    s.speech = new SpeechParameters(0.2, 0.05, 0.5, 0.3, 0.05, List.of(0.5, 0.3, 0.2));
                }), bowls.with(s -> s.rewards = new Rewards(50, -150, -2, 1, MatchScore.KL, 0.95)));
    }

    /** Beliefs that random dialogues lead to. */
    private static List<HandoverBelief> beliefs(HandoverDomain domain, RandomGenerator random) {
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        HandoverState s = domain.initialState(domain.spec().objects().get(0).name());
        HandoverBelief belief = HandoverBelief.initial(domain);
        List<HandoverBelief> all = new ArrayList<>();
        for (int k = 0; k < 5 && !belief.task().done(); k++) {
            all.add(belief);
            Act act = s.task().legalActs().get(random.nextInt(s.task().legalActs().size())).act();
            s = (HandoverState) model.sample(s, act).op;
            belief = belief.after(act).given(senses.sample(s, act));
        }
        return all;
    }

    private static <N> double[] values(BeliefSearch<N> mdp, HandoverBelief belief, int horizon, int width, boolean leaves) {
        N root = mdp.node();
        mdp.load(root, belief);
        double[] q = new double[belief.scene().acts().size()];
        new SparseSampling<>(mdp, width, leaves).values(root, horizon, 17, Deadline.NONE, q);
        return q;
    }

    private static <N> double[] relevance(BeliefSearch<N> mdp, HandoverBelief belief) {
        N root = mdp.node();
        mdp.load(root, belief);
        return IntStream.range(0, mdp.acts(root)).mapToDouble(a -> mdp.relevance(root, a)).toArray();
    }

    private static HandoverSearch plain(HandoverBelief belief) {
        return new HandoverSearch(belief.scene(), new ConcurrentHashMap<>());
    }

    @ParameterizedTest
    @MethodSource("specs")
    void withOneMindItIsThePlainSearch(DomainSpec spec) {
        HandoverDomain domain = DomainFiles.domain(spec);
        for (int e = 0; e < 2; e++) {
            for (HandoverBelief belief : beliefs(domain, new SplittableRandom(e))) {
                assertArrayEquals(relevance(plain(belief), belief), relevance(new NestedSearch(plain(belief), 8), belief), 1e-9);
                for (boolean leaves : new boolean[] {true, false}) {
                    assertArrayEquals(values(plain(belief), belief, 3, 1, leaves),
                            values(new NestedSearch(plain(belief), 8), belief, 3, 1, leaves), 1e-9, belief + ", " + belief.task());
                }
            }
        }
    }

    /** The same numbers in the limit, with all the machinery at work; without leaves, which break ties of b by its last digits. */
    @ParameterizedTest
    @MethodSource("specs")
    void hardlyAnyMisperceptionHardlyMatters(DomainSpec spec) {
        HandoverDomain base = DomainFiles.domain(spec);
        HandoverDomain hardly = DomainFiles.domain(spec.with(s -> s.perception = new PerceptionParameters(1e-14, 1e-14, 50)));
        List<HandoverBelief> right = beliefs(base, new SplittableRandom(4));
        for (HandoverBelief b : right) {
            HandoverBelief start = HandoverBelief.of(b.task().settled(), b.probabilities(), b.human());
            HandoverBelief same = HandoverBelief.of(hardly.task(hardly.scene(b.scene().objects())), b.probabilities(), b.human());
            if (start.task().openReference() == null && start.task().target() == null && start.task().handovers() == 0) {
                assertArrayEquals(values(plain(start), start, 2, 3, false),
                        values(new NestedSearch(plain(same), 8), same, 2, 3, false), 1e-9, b.toString());
            }
        }
    }

    /** A yes is worth less where it may be to another question: with a quarter misread the robot does not hand over at once. */
    @Test
    void knowsThatItMayBeMisread() {
        DomainSpec spec = DomainFiles.read("bowls-and-spoons");
        HandoverDomain understood = DomainFiles.domain(spec);
        HandoverDomain misread = DomainFiles.domain(spec.with(s -> s.perception = new PerceptionParameters(0, 0.25, 50)));
        assertEquals(Act.of("PICK", "metal_bowl"), afterYes(understood));
        assertTrue(!afterYes(misread).verb().equals("PICK"));
    }

    private static Act afterYes(HandoverDomain domain) {
        HandoverBelief belief = HandoverBelief.initial(domain).after(Act.of("ASK", "metal_bowl"))
                .given(new Observation(Speech.of("yes", domain.vocabulary()), null, PickSignal.NONE));
        return new Poss(2, 20, true).solve(domain, new SplittableRandom(1)).decide(belief, Deadline.NONE, new SplittableRandom(1)).act();
    }

    /**
     * 4,000 observations for each act, all minds: the standard error of a value is below 45 / sqrt(4,000) = 0.7 even without strata,
     * with them several times smaller; the seed is fixed. The oracle enumerates states and observations.
     */
    @Test
    void twoActsAheadAgreeWithTheModel() {
        HandoverDomain domain = new HandoverDomain(SmallHandover.spec().with(s -> s.perception = new PerceptionParameters(0.2, 0.2, 600)));
        HandoverBelief belief = HandoverBelief.initial(domain);
        double[] found = values(BeliefSearch.of(belief.scene(), new ConcurrentHashMap<>()), belief, 2, 4000, false);
        for (int a = 0; a < found.length; a++) {
            assertEquals(NestedOracle.q(domain, belief, belief.scene().acts().get(a).act()), found[a], 1, "" + belief.scene().acts().get(a));
        }
    }
}
