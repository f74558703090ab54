package handover.solver;

import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import java.util.List;
import java.util.random.RandomGenerator;

/** The floor: any legal act, each as likely as the other. */
public record RandomActs() implements Solver {
    @Override
    public String name() {
        return "random";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            List<ActModel> acts = belief.task().legalActs();
            return Decision.of(acts.get(chance.nextInt(acts.size())).act());
        };
    }
}
