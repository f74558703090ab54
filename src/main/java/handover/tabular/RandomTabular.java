package handover.tabular;

import java.util.random.RandomGenerator;

/** Any act, each as likely as the other. */
record RandomTabular() implements TabularSolver {
    @Override
    public String name() {
        return "random";
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        return (belief, deadline, chance) -> TabularDecision.of(chance.nextInt(pomdp.acts().size()));
    }
}
