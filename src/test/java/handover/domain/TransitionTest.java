package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.TransitionOracle.Outcome;
import handover.domain.TransitionOracle.Weight;
import handover.math.GoodnessOfFit;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** MODEL 2, 5, 6: transitions and rewards of any base domain against the oracle, and the sampler against both. */
class TransitionTest {
    private static final int WALK = 6;
    private static final int DRAWS = 4000;
    /** Of one chi-square test; 40 tests a run make 4e-5 for the class. */
    private static final double FALSE_ALARM = 1e-6;

    @Property(tries = 250, seed = "51", edgeCases = EdgeCasesMode.NONE)
    void outcomesAreThoseOfTheText(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(1));
        HandoverState s = start(domain, random);
        for (int t = 0; t < WALK && !s.task().done(); t++) {
            Act act = AnyDomain.oneOf(s.task().legalActs(), random).act();
            Map<Outcome, Weight> expected = TransitionOracle.outcomes(spec, s, act);
            Map<Outcome, Weight> found = found(model.transitions(s, act), s, act);
            assertEquals(1, found.values().stream().mapToDouble(Weight::probability).sum(), 1e-12, "sum after " + act);
            assertEquals(significant(expected).keySet(), significant(found).keySet(), () -> "outcomes of " + act);
            expected.forEach((outcome, w) -> {
                Weight f = found.getOrDefault(outcome, new Weight(0, 0));
                assertEquals(w.probability(), f.probability(), 1e-9, () -> "probability of " + act + " -> " + outcome);
                assertEquals(w.reward(), f.reward(), 1e-9, () -> "reward of " + act + " -> " + outcome);
            });
            s = (HandoverState) model.sample(s, act).op;
        }
    }

    /** A state with any h. */
    private static HandoverState start(HandoverDomain domain, Random random) {
        int n = domain.start().size();
        return new HandoverState(random.nextInt(n), domain.task(domain.start()), AnyDomain.simplex(n, random));
    }

    private static Map<Outcome, Weight> found(List<TransitionProb> all, HandoverState s, Act act) {
        Map<Outcome, Weight> found = new HashMap<>();
        for (TransitionProb t : all) {
            assertTrue(t.p > 0, "an outcome of probability " + t.p);
            assertSame(s, t.eo.o, "where it came from");
            assertEquals(act, t.eo.a, "by which act");
            HandoverState next = (HandoverState) t.eo.op;
            assertEquals(next.task().done(), t.eo.terminated, "terminated");
            found.merge(TransitionOracle.of(next), new Weight(t.p, t.p * t.eo.r),
                    (a, b) -> new Weight(a.probability() + b.probability(), a.reward() + b.reward()));
        }
        return found;
    }

    /** Without what rounding made of a probability of 0. */
    private static Map<Outcome, Weight> significant(Map<Outcome, Weight> all) {
        Map<Outcome, Weight> most = new HashMap<>(all);
        most.values().removeIf(w -> w.probability() < 1e-12);
        return most;
    }

    @Property(tries = 100, seed = "52", edgeCases = EdgeCasesMode.NONE)
    void terminalStatesAbsorb(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(2));
        HandoverState s = start(domain, random);
        for (int t = 0; t < 200 && !s.task().done(); t++) {
            assertFalse(model.terminal(s), "not yet");
            String x = s.task().scene().objects().get(random.nextBoolean() ? s.wanted() : 0).name();
            s = (HandoverState) model.sample(s, Act.of("PICK", x)).op;
        }
        assertTrue(model.terminal(s), () -> "200 picks and not done: " + spec.handovers() + ", " + spec.wrongPick());
        HandoverState end = s;
        assertEquals(List.of(Act.WAIT), end.task().legalActs().stream().map(ActModel::act).toList(), "legal at the end");
        for (TransitionProb t : model.transitions(end, Act.WAIT)) {
            assertEquals(end, t.eo.op, "stays");
            assertEquals(1, t.p, 0, "surely");
            assertEquals(0, t.eo.r, 0, "for nothing");
            assertTrue(t.eo.terminated, "and is over");
        }
        assertEquals(end, model.sample(end, Act.WAIT).op, "sampled");
    }

    @Property(tries = 40, seed = "53", edgeCases = EdgeCasesMode.NONE)
    void theSamplerDrawsFromTheTransitions(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(random.nextLong()));
        HandoverState s = start(domain, random);
        Act act = AnyDomain.oneOf(s.task().legalActs(), random).act();
        Map<Outcome, Double> expected = new LinkedHashMap<>();
        found(model.transitions(s, act), s, act).forEach((o, w) -> expected.put(o, w.probability()));
        Map<Outcome, Long> counts = new HashMap<>();
        for (int k = 0; k < DRAWS; k++) {
            counts.merge(TransitionOracle.of((HandoverState) model.sample(s, act).op), 1L, Long::sum);
        }
        GoodnessOfFit.assertFits("after " + act, counts, expected, FALSE_ALARM);
    }

    @Property(tries = 30, seed = "54", edgeCases = EdgeCasesMode.NONE)
    void actsThatAreNotOfferedAreRefused(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(3));
        HandoverState s = start(domain, random);
        for (Act act : List.of(Act.of("PICK", "nothing"), Act.of("PICK"), Act.of("DANCE"), Act.of("WAIT", "thing_0"))) {
            assertThrows(IllegalArgumentException.class, () -> model.transitions(s, act), act::toString);
            assertThrows(IllegalArgumentException.class, () -> model.sample(s, act), act::toString);
        }
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
