package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.math.Simplex;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * The greedy communicator: hands over when sure enough ({@link PickWhenSure}); else does what makes the human's belief match the
 * robot's best in this step by the domain's match reward, whatever it costs: communicates, or waits. Its values are these match
 * rewards. Of equally good acts it does the first, and waiting is the first of all.
 */
public record Greedy() implements Solver {
    @Override
    public String name() {
        return "greedy";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            Act pick = PickWhenSure.pick(belief);
            return pick == null ? communicate(belief, deadline) : Decision.of(pick);
        };
    }

    private static Decision communicate(HandoverBelief belief, Deadline deadline) {
        HandoverDomain domain = belief.domain();
        Scene scene = belief.scene();
        int n = scene.size();
        double[] b = belief.probabilities().clone();
        Simplex.propagate(domain.spec().tau(), b, b, n);
        double[] human = new double[n];
        Map<Act, Double> values = new LinkedHashMap<>();
        Act best = Act.WAIT;
        for (ActModel act : scene.acts()) {
            if (!values.isEmpty() && deadline.passed()) {
                return new Decision(best, values, 0, values.size(), false);
            }
            if (!act.isPick()) {
                domain.understand(act, belief.human(), human, n);
                double match = domain.matchReward(b, human, n);
                best = values.isEmpty() || match > values.get(best) ? act.act() : best;
                values.put(act.act(), match);
            }
        }
        return new Decision(best, values, 0, values.size(), true);
    }
}
