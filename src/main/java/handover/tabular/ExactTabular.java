package handover.tabular;

import handover.math.Simplex;
import handover.solver.Deadline;
import java.util.random.RandomGenerator;

/**
 * {@link LookAhead} over H acts, with nothing after them. With a deadline it deepens from 1 to H.
 *
 * @param horizon H, at least 1
 */
record ExactTabular(int horizon) implements TabularSolver {
    @Override
    public String name() {
        return "exact:H=" + horizon;
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            LookAhead look = new LookAhead(pomdp);
            double[] best = new double[pomdp.acts().size()];
            double[] next = new double[best.length];
            int depth = deadline == Deadline.NONE ? horizon : 1;
            look.values(belief, depth, Deadline.NONE, best);
            while (depth < horizon && !deadline.passed() && look.values(belief, depth + 1, deadline, next)) {
                System.arraycopy(next, 0, best, 0, next.length);
                depth++;
            }
            return new TabularDecision(Simplex.argmax(best, best.length), Double.NaN, Double.NaN, depth, look.nodes(), depth == horizon);
        };
    }
}
