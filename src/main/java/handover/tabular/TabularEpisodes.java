package handover.tabular;

import handover.math.Simplex;
import handover.math.Streams;
import handover.solver.Deadline;
import java.util.Arrays;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;

/**
 * Plays episodes of one solver on a tabular problem. Episode k is a function of seed and k alone (but for the times that decisions took,
 * and for decisions under a deadline). Thread safe.
 */
public final class TabularEpisodes {
    private final TabularPomdp m;
    private final TabularPolicy policy;
    private final long seed;
    private final int steps;
    private final Supplier<Deadline> deadlines;
    private final LongSupplier nanoClock;

    /**
     * What one episode was worth.
     *
     * @param discountedReturn sum of gamma^t r_t
     * @param steps acts
     * @param unforeseen observations that the model says cannot be
     * @param decisionNanos how long each decision took
     */
    public record Outcome(double discountedReturn, int steps, int unforeseen, long[] decisionNanos) {}

    /**
     * @param steps acts at which an episode is cut off
     * @param deadlines gives the deadline of each decision when it starts
     * @param nanoClock for measuring decisions only
     */
    public TabularEpisodes(TabularPomdp m, TabularPolicy policy, long seed, int steps, Supplier<Deadline> deadlines,
            LongSupplier nanoClock) {
        this.m = m;
        this.policy = policy;
        this.seed = seed;
        this.steps = steps;
        this.deadlines = deadlines;
        this.nanoClock = nanoClock;
    }

    /** Acts after which nothing that is still to come is worth more than {@code share} of everything; at most 10,000. */
    public static int horizon(double discount, double share) {
        return discount == 0 ? 1 : discount == 1 ? 10_000 : (int) Math.min(10_000, Math.ceil(Math.log(share) / Math.log(discount)));
    }

    /** Plays episode {@code index}. */
    public Outcome play(int index) {
        RandomGenerator nature = Streams.of(seed, "nature", index);
        RandomGenerator chance = Streams.of(seed, "planner", index);
        TabularBelief belief = TabularBelief.start(m);
        int state = Simplex.sample(belief.probabilities(), belief.probabilities().length, nature);
        double earned = 0;
        double discount = 1;
        long[] nanos = new long[steps];
        int t = 0;
        while (t < steps && !m.terminal(state)) {
            long before = nanoClock.getAsLong();
            int act = policy.decide(belief.probabilities(), deadlines.get(), chance).act();
            nanos[t++] = nanoClock.getAsLong() - before;
            int next = next(state, act, nature.nextDouble());
            int seen = m.observed(act, next, nature.nextDouble());
            earned += discount * m.reward(act, state, next, seen);
            discount *= m.discount();
            belief = belief.after(m, act, seen);
            state = next;
        }
        return new Outcome(earned, t, belief.unforeseen(), Arrays.copyOf(nanos, t));
    }

    private int next(int state, int act, double u) {
        int at = act * m.states().size() + state;
        int k = m.row[at];
        for (double left = u - m.probability[k]; left >= 0 && k < m.row[at + 1] - 1; left -= m.probability[k]) {
            k++;
        }
        return m.next[k];
    }
}
