package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.io.DomainFiles;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The anytime planner on the shipped domains: against POSS with many more samples, bounds, deadlines. */
class AnytimeTest {
    /** Beliefs before the acts of episodes that POSS plays. */
    private static List<HandoverBelief> beliefs(HandoverDomain domain, int count) {
        RandomGenerator random = new SplittableRandom(17);
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        Policy play = new Poss(2, 5, true).solve(domain, random);
        List<HandoverBelief> all = new ArrayList<>();
        while (all.size() < count) {
            double[] prior = domain.prior(domain.start());
            HandoverState state = domain.initialState(domain.start().objects().get(Simplex.sample(prior, prior.length, random)).name());
            HandoverBelief belief = HandoverBelief.initial(domain);
            while (!belief.task().done() && all.size() < count) {
                all.add(belief);
                Act act = play.decide(belief, Deadline.NONE, random).act();
                state = (HandoverState) model.sample(state, act).op;
                belief = belief.after(act).given(senses.sample(state, act));
            }
        }
        return all;
    }

    /**
     * By the values of POSS with 400 samples, what the planner's acts lose is on average less than what those of POSS with 10
     * samples lose; over 60 beliefs the first is about 0.03 +- 0.02 and the second 0.2 +- 0.04 (measured), so that the odds of
     * the reverse are far below 1e-3 for another seed.
     */
    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-communicated", "table-line-5"})
    void losesLessThanPoss(String name) {
        HandoverDomain domain = DomainFiles.load(name);
        Policy reference = new Poss(2, 400, true).solve(domain, null);
        Policy poss = new Poss(2, 10, true).solve(domain, null);
        Policy anytime = new Anytime(2, 256).solve(domain, null);
        double lostByPoss = 0;
        double lost = 0;
        for (HandoverBelief belief : beliefs(domain, 60)) {
            Decision best = reference.decide(belief, Deadline.NONE, new SplittableRandom(1));
            double value = best.values().get(best.act());
            lostByPoss += value - best.values().get(poss.decide(belief, Deadline.NONE, new SplittableRandom(2)).act());
            lost += value - best.values().get(anytime.decide(belief, Deadline.NONE, new SplittableRandom(2)).act());
        }
        assertTrue(lost < lostByPoss, lost + " against " + lostByPoss);
    }

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-incremental", "bowls-communicated", "table-line-6"})
    void theBoundsEncloseWhatPossExpects(String name) {
        HandoverDomain domain = DomainFiles.load(name);
        Policy anytime = new Anytime(2, 64).solve(domain, null);
        Policy poss = new Poss(2, 100, true).solve(domain, null);
        for (HandoverBelief belief : beliefs(domain, 10)) {
            Bounds bounds = anytime.decide(belief, Deadline.NONE, new SplittableRandom(1)).bounds();
            Decision decision = poss.decide(belief, Deadline.NONE, new SplittableRandom(1));
            double value = decision.values().get(decision.act());
            assertTrue(bounds.lower() <= value + 1.5 && value - 1.5 <= bounds.upper(), value + " in " + bounds);
        }
    }

    /** With H = 2 &lt; K = 3 increments a pick is started all the same, and followed through. */
    @Test
    void reachesForWhatIsWanted() {
        HandoverDomain domain = DomainFiles.load("bowls-incremental");
        Policy anytime = new Anytime(2, 64).solve(domain, null);
        double[] sure = Simplex.vertex(4, 2);
        HandoverBelief belief = HandoverBelief.of(domain.task(domain.start()), sure, Simplex.uniform(4));
        Act pick = Act.of("PICK", domain.start().objects().get(2).name());
        for (int k = 0; k < 3; k++) {
            assertEquals(pick, anytime.decide(belief, Deadline.NONE, new SplittableRandom(k)).act());
            belief = k < 2 ? belief.after(pick) : belief;
        }
    }

    @Test
    void aDeadlineThatHasPassedLeavesALegalActAndItsBounds() {
        HandoverDomain domain = DomainFiles.load("kitchen-20");
        Decision decision = new Anytime(3, 128).solve(domain, null)
                .decide(HandoverBelief.initial(domain), () -> true, new SplittableRandom(1));
        assertEquals(1, decision.depth());
        assertFalse(decision.finished());
        assertTrue(domain.start().model(decision.act()) != null && decision.bounds().lower() <= decision.bounds().upper());
    }

    @Test
    void refusesAHorizonBelowTwoOrFewDraws() {
        assertThrows(IllegalArgumentException.class, () -> new Anytime(1, 128));
        assertThrows(IllegalArgumentException.class, () -> new Anytime(3, 7));
    }
}
