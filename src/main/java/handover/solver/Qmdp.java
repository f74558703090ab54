package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.math.Simplex;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import java.util.random.RandomGenerator;

/**
 * QMDP: the act that would be best if what is wanted became known after this step ({@link KnownWish}). It never acts in order
 * to learn; what people say of themselves is all that it goes by. A deadline ends the comparison of acts early.
 *
 * <p>Source: Littman, Cassandra and Kaelbling, "Learning policies for partially observable environments: scaling up" (1995).
 */
public record Qmdp() implements Solver {
    /** What is kept about tables is dropped when there are more of them. */
    private static final int MOST_SCENES = 256;

    @Override
    public String name() {
        return "qmdp";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        ConcurrentMap<Scene, KnownWish> known = new ConcurrentHashMap<>();
        known.put(domain.start(), new KnownWish(domain.start()));
        return (belief, deadline, chance) -> {
            if (known.size() > MOST_SCENES) {
                known.clear();
            }
            return new Step(belief, known.computeIfAbsent(belief.scene(), KnownWish::new)).decide(deadline);
        };
    }

    /** One decision. */
    private static final class Step {
        private final HandoverBelief belief;
        private final HandoverDomain domain;
        private final KnownWish known;
        private final KnownWish.Path path;
        private final int n;
        /** b after the transition of what is wanted. */
        private final double[] b;
        private final double[] human;

        Step(HandoverBelief belief, KnownWish known) {
            this.belief = belief;
            this.known = known;
            domain = belief.domain();
            path = known.path();
            n = belief.scene().size();
            b = belief.probabilities().clone();
            Simplex.propagate(domain.spec().tau(), b, b, n);
            human = new double[n];
        }

        Decision decide(Deadline deadline) {
            Map<Act, Double> values = new LinkedHashMap<>();
            Act best = null;
            for (ActModel act : belief.scene().acts()) {
                if (best != null && deadline.passed()) {
                    return new Decision(best, values, 1, values.size(), false);
                }
                double value = value(belief.task().effect(act.index()));
                values.put(act.act(), value);
                best = best == null || value > values.get(best) ? act.act() : best;
            }
            return new Decision(best, values, 1, values.size(), true);
        }

        private double value(ActEffect effect) {
            domain.understand(effect.model(), belief.human(), human, n);
            double works = effect.completes() ? completed(effect) : domain.discount() * told(effect);
            double onward = effect.stalled() == null ? works
                    : effect.advance() * works + (1 - effect.advance()) * domain.discount() * told(effect.stalled());
            return effect.reward() + domain.matchReward(b, human, n) + onward;
        }

        private double completed(ActEffect effect) {
            double right = b[effect.model().target()];
            return outcome(effect, true, right) + outcome(effect, false, 1 - right);
        }

        private double outcome(ActEffect effect, boolean right, double probability) {
            return probability
                    * (domain.pickReward(right) + domain.discount() * known.afterPick(effect.during().completed(right)));
        }

        /** The expected value once it is known what is wanted. */
        private double told(ActEffect effect) {
            double sum = 0;
            for (int i = 0; i < n; i++) {
                sum += b[i] > 0 ? b[i] * path.value(i, effect.during(), human) : 0;
            }
            return sum;
        }
    }
}
