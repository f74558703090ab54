package handover.tabular;

import java.util.random.RandomGenerator;

/**
 * Does what looks best if more were told than will be: the state after one step (QMDP), or after one more observation (the fast
 * informed bound). Needs no time, and asks for nothing that it would be told.
 *
 * @param fast whether by the fast informed bound
 */
record Informed(boolean fast) implements TabularSolver {
    @Override
    public String name() {
        return fast ? "fib" : "qmdp";
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        InitialBounds bounds = new InitialBounds(pomdp);
        double[] values = fast ? bounds.fib() : bounds.qmdp();
        return (belief, deadline, chance) -> {
            int best = 0;
            double most = Double.NEGATIVE_INFINITY;
            for (int a = 0; a < pomdp.acts().size(); a++) {
                double v = TabularPomdp.dot(belief, values, a * belief.length);
                best = v > most ? a : best;
                most = Math.max(most, v);
            }
            return new TabularDecision(best, bounds.lower().value(belief), most, 0, 1, true);
        };
    }
}
