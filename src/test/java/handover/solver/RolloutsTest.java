package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.IncrementalPickDomain;
import handover.domain.Rewards;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;

/** Rollouts: by hand where nothing is left to chance, and against episodes of the same policy on BURLAP's model. */
class RolloutsTest {
    private static final double GAMMA = 0.95;

    private final HandoverDomain domain = new IncrementalPickDomain(spec());
    private final HandoverSearch search = new HandoverSearch(domain.start());

    private static DomainSpec spec() {
        return SmallHandover.spec().with(s -> s.rewards = new Rewards(50, -150, -2, 1, MatchScore.NONE, GAMMA));
    }

    private HandoverBelief believing(double p) {
        return HandoverBelief.of(domain.task(domain.start()), new double[] {p, 1 - p}, Simplex.uniform(2));
    }

    private double draw(HandoverBelief belief, Act act, double stratum, long seed) {
        return new Rollouts<>(search).draw(search.root(belief), domain.start().model(act).index(), stratum, seed, Deadline.NONE);
    }

    @Test
    void whoIsSureReachesUntilItIsDone() {
        for (int seed = 0; seed < 10; seed++) {
            assertEquals(-1 - GAMMA - GAMMA * GAMMA + GAMMA * GAMMA * 50, draw(believing(1), Act.of("PICK", "cup"), 0.5, seed), 1e-9);
            assertEquals(-1 + GAMMA * (-1 - GAMMA - GAMMA * GAMMA + GAMMA * GAMMA * 50), draw(believing(1), Act.WAIT, 0.5, seed), 1e-9);
        }
    }

    /**
     * The same policy in 4,000 episodes on BURLAP's model: returns lie within 200, with a standard deviation of about 30, so that
     * each mean has a standard error of about 0.5; a miss by 3 is more than four of those of the difference (odds below 1e-4).
     */
    @Test
    void areWorthOnAverageWhatEpisodesEarn() {
        int count = 4000;
        RandomGenerator random = new SplittableRandom(3);
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        Act first = Act.of("PICK", "cup");
        double rolled = 0;
        double earned = 0;
        for (int e = 0; e < count; e++) {
            rolled += draw(believing(0.6), first, random.nextDouble(), random.nextLong()) / count;
            HandoverState state = domain.initialState(random.nextDouble() < 0.6 ? "cup" : domain.start().objects().get(1).name());
            HandoverBelief belief = believing(0.6);
            double discount = 1;
            for (int k = 0; k < 60 && !belief.task().done(); k++) {
                Act act = k == 0 ? first : domain.start().acts().get(search.simple(search.root(belief))).act();
                var outcome = model.sample(state, act);
                earned += discount * outcome.r / count;
                discount *= GAMMA;
                state = (HandoverState) outcome.op;
                belief = belief.after(act).given(senses.sample(state, act));
            }
        }
        assertEquals(earned, rolled, 3);
        assertTrue(earned > 20, "the policy hands over: " + earned);
    }

    @Test
    void thereAreNoneWhereAPickIsOneIncrement() {
        HandoverDomain base = new HandoverDomain(spec());
        HandoverSearch plain = new HandoverSearch(base.start());
        assertEquals(-1, plain.simple(plain.root(HandoverBelief.initial(base))));
    }
}
