package handover.solver;

import handover.domain.HandoverDomain;
import java.util.random.RandomGenerator;

/** The ceiling: is shown what the human wants and hands it over at once. */
public record Clairvoyant() implements Solver {
    @Override
    public String name() {
        return "clairvoyant";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return new Threshold(0).solve(domain, random);
    }

    @Override
    public boolean clairvoyant() {
        return true;
    }
}
