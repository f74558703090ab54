package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.model.TransitionProb;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;

/** MODEL 7: the model over pairs and the fast equivalent with 3 sum_i b(i) h'(i) are the same, to 1e-9. */
class CommunicatedRewardTest {
    private static final CommunicatedObjectDomain LINEAR =
            (CommunicatedObjectDomain) DomainFiles.load("table-line-6-communicated");
    private static final CommunicatedObjectDomain BRIER = (CommunicatedObjectDomain) DomainFiles.domain(
            LINEAR.spec().with(s -> s.communicated = new CommunicatedParameters(3, MatchScore.BRIER)));

    private static double[] distribution(SplittableRandom random, int n) {
        double[] p = random.doubles(n).map(u -> -Math.log(1 - u)).toArray();
        double sum = Arrays.stream(p).sum();
        return Arrays.stream(p).map(x -> x / sum).toArray();
    }

    /** Expected reward of the pairs' model minus what is not for being understood. */
    private static double paidForBeingUnderstood(CommunicatedObjectDomain domain, Task task, double[] b, double[] h, ActModel act) {
        FullModel model = (FullModel) domain.generateDomain(new SplittableRandom(0)).getModel();
        double paid = 0;
        for (int i = 0; i < b.length; i++) {
            for (Map.Entry<State, Double> pair : domain.hidden(new HandoverState(i, task, h)).entrySet()) {
                for (TransitionProb t : model.transitions(pair.getKey(), act.act())) {
                    double rest = task.effect(act.act()).reward()
                            + (act.isPick() ? domain.pickReward(act.target() == i) : 0);
                    paid += b[i] * pair.getValue() * t.p * (t.eo.r - rest);
                }
            }
        }
        return paid;
    }

    @Property(tries = 60)
    void expectedRewardOfThePairsIsThreeTimesTheOverlap(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Scene scene = LINEAR.start();
        Task task = LINEAR.task(scene);
        double[] b = distribution(random, scene.size());
        double[] h = distribution(random, scene.size());
        for (ActModel act : scene.acts()) {
            double[] after = LINEAR.understood(act, h);
            double overlap = 0;
            for (int i = 0; i < b.length; i++) {
                overlap += b[i] * after[i];
            }
            assertEquals(3 * overlap, paidForBeingUnderstood(LINEAR, task, b, h, act), 1e-9, act + " seed " + seed);
            assertEquals(3 * overlap, LINEAR.matchReward(b, after, b.length), 1e-12, act + " seed " + seed);
        }
    }

    @Property(tries = 20)
    void aProperScoreInItsPlaceIsTheSameOnBothLevels(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Task task = BRIER.task(BRIER.start());
        double[] b = distribution(random, BRIER.start().size());
        double[] h = distribution(random, BRIER.start().size());
        for (ActModel act : BRIER.start().acts()) {
            assertEquals(BRIER.matchReward(b, BRIER.understood(act, h), b.length),
                    paidForBeingUnderstood(BRIER, task, b, h, act), 1e-9, act + " seed " + seed);
        }
    }
}
