package handover.solver;

import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * The floor: any legal act, each as likely as the other; but a pick that takes increments is finished once it is begun, or it
 * would hardly ever complete.
 */
public record RandomActs() implements Solver {
    @Override
    public String name() {
        return "random";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            if (belief.task().target() != null) {
                return Decision.of(Act.of(PickType.VERB, belief.task().target()));
            }
            List<ActModel> acts = belief.task().legalActs();
            return Decision.of(acts.get(chance.nextInt(acts.size())).act());
        };
    }
}
