package handover.tabular;

import handover.math.Simplex;
import handover.solver.Deadline;
import handover.solver.SparseSampling;
import java.util.random.RandomGenerator;

/**
 * Sparse sampling, as POSS: H acts ahead with C observations for each, and at the leaves what the best single act earns if it is done for
 * ever. With a deadline it deepens from 1 to H.
 *
 * @param horizon H, at least 1
 * @param width C, at least 1
 */
record TabularPoss(int horizon, int width) implements TabularSolver {
    @Override
    public String name() {
        return "poss:H=" + horizon + ",C=" + width;
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        Alphas leaves = new InitialBounds(pomdp).lower();
        return (belief, deadline, chance) -> decide(pomdp, leaves, belief, deadline, chance.nextLong());
    }

    private TabularDecision decide(TabularPomdp pomdp, Alphas leaves, double[] belief, Deadline deadline, long seed) {
        TabularSearch mdp = new TabularSearch(pomdp, leaves);
        SparseSampling<TabularSearch.Node> sampling = new SparseSampling<>(mdp, width, true);
        TabularSearch.Node root = mdp.belief(belief);
        double[] best = new double[pomdp.acts().size()];
        double[] next = new double[best.length];
        int depth = deadline == Deadline.NONE ? horizon : 1;
        sampling.values(root, depth, seed, Deadline.NONE, best);
        while (depth < horizon && !deadline.passed() && sampling.values(root, depth + 1, seed, deadline, next)) {
            System.arraycopy(next, 0, best, 0, next.length);
            depth++;
        }
        int act = Simplex.argmax(best, best.length);
        return new TabularDecision(act, Double.NaN, Double.NaN, depth, sampling.nodes(), depth == horizon);
    }
}
