package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.math.Simplex;

/**
 * When baselines hand over: once the expected reward of completing a pick of the likeliest object now, p R+ + (1 - p) R-,
 * exceeds gamma R+, that of a pick that is sure to be right but completes a step later. With increments both sides are as many
 * steps further away, so that nothing changes; the rule is asked again before each increment, so that an objection calls the pick off.
 */
final class PickWhenSure {
    private PickWhenSure() {}

    /** The pick, or the next increment of it; null if nothing is sure enough. */
    static Act pick(HandoverBelief belief) {
        HandoverDomain domain = belief.domain();
        double[] b = belief.probabilities();
        int x = Simplex.argmax(b, b.length);
        double expected = domain.expectedPickReward(b[x]);
        return expected > domain.discount() * domain.pickReward(true)
                ? Act.of(PickType.VERB, belief.scene().objects().get(x).name()) : null;
    }
}
