package handover.solver;

import handover.math.SeededRandom;
import handover.math.Streams;
import java.util.ArrayList;
import java.util.List;

/**
 * Partially observable sparse sampling: depth-first look-ahead of H acts on the belief MDP with C sampled observations for
 * each act, on one node per level that is used again and again. The last level takes expected rewards and leaf values
 * without sampling, and leaves out acts that cannot be the best. The C observations come from C equal parts of the
 * distribution of hidden states, which changes no expectation and lowers the variance. Used by one thread at a time.
 *
 * <p>Source: Kearns, Mansour and Ng, "A sparse sampling algorithm for near-optimal planning in large Markov decision
 * processes" (2002), on beliefs as in the report, section 3.
 *
 * @param <N> node of the problem
 */
public final class SparseSampling<N> {
    private static final int NODES_BETWEEN_CHECKS = 16;

    private final BeliefMdp<N> mdp;
    private final int width;
    private final boolean leaves;
    private final List<Level<N>> levels = new ArrayList<>();
    private Deadline deadline = Deadline.NONE;
    private final SeededRandom random = new SeededRandom();
    private long nodes;
    private int untilCheck;
    private boolean stopped;

    /** The nodes that the search needs at one depth. */
    private record Level<N>(N predicted, N outcome, N next) {}

    /**
     * @param width C, observations sampled for each act, at least 1
     * @param leaves whether the beliefs at depth H are worth their {@link BeliefMdp#leaf}, or 0
     */
    public SparseSampling(BeliefMdp<N> mdp, int width, boolean leaves) {
        this.mdp = mdp;
        this.width = width;
        this.leaves = leaves;
    }

    /** Beliefs visited since construction. */
    public long nodes() {
        return nodes;
    }

    /**
     * Values of all acts at {@code root}, looking {@code horizon} acts ahead. The numbers drawn follow from {@code seed} and
     * from which samples lead to a node, not from the acts: they are common to all acts that are compared.
     *
     * @param q receives the values; modified
     * @return false if the deadline passed first: then {@code q} is undefined
     */
    public boolean values(N root, int horizon, long seed, Deadline limit, double[] q) {
        return values(root, horizon, seed, limit, q, 0, 1);
    }

    /** The same for the acts {@code first}, {@code first + step} and so on; the other entries of {@code q} are left as they are. */
    boolean values(N root, int horizon, long seed, Deadline limit, double[] q, int first, int step) {
        begin(horizon, limit);
        int acts = mdp.acts(root);
        for (int a = first; a < acts && !stopped; a += step) {
            q[a] = actValue(root, a, horizon, seed);
        }
        return !stopped;
    }

    /**
     * One draw of the value of an act: as {@link #values}, but with a single observation of each outcome of this act.
     *
     * @param horizon at least 2
     * @param stratum in [0, 1): which part of the distribution of hidden states the observation comes from
     * @return NaN if the deadline passed first
     */
    double draw(N root, int act, int horizon, double stratum, long seed, Deadline limit) {
        begin(horizon, limit);
        Level<N> level = levels.get(horizon);
        double value = mdp.start(root, act, level.predicted);
        int outcomes = mdp.outcomes(level.predicted);
        for (int k = 0; k < outcomes && !stopped; k++) {
            double p = mdp.outcome(level.predicted, k, level.outcome);
            if (p > 0 && mdp.acts(level.outcome) > 0) {
                value += mdp.discount() * p * onward(level, horizon, stratum, seed);
            }
        }
        return stopped ? Double.NaN : value;
    }

    private double onward(Level<N> level, int horizon, double stratum, long seed) {
        if (!mdp.sampled(level.outcome)) {
            return value(level.outcome, horizon - 1, seed);
        }
        random.seed(seed);
        mdp.sample(level.outcome, stratum, random, level.next);
        return value(level.next, horizon - 1, seed);
    }

    private void begin(int horizon, Deadline limit) {
        while (levels.size() <= horizon) {
            levels.add(new Level<>(mdp.node(), mdp.node(), mdp.node()));
        }
        deadline = limit;
        stopped = false;
        untilCheck = NODES_BETWEEN_CHECKS;
    }

    private double value(N node, int horizon, long seed) {
        nodes++;
        if (--untilCheck == 0) {
            untilCheck = NODES_BETWEEN_CHECKS;
            stopped = deadline.passed();
        }
        int acts = mdp.acts(node);
        if (acts == 0) {
            return 0;
        }
        if (horizon == 1) {
            return mdp.last(node, leaves, levels.get(1).predicted);
        }
        double best = Double.NEGATIVE_INFINITY;
        for (int a = 0; a < acts && !stopped; a++) {
            if (mdp.bound(node, a) > best) {
                best = Math.max(best, actValue(node, a, horizon, seed));
            }
        }
        return best;
    }

    private double actValue(N node, int act, int horizon, long seed) {
        Level<N> level = levels.get(horizon);
        double reward = mdp.start(node, act, level.predicted);
        if (horizon == 1) {
            return mdp.ending(reward, leaves, level.predicted);
        }
        double future = 0;
        int outcomes = mdp.outcomes(level.predicted);
        for (int k = 0; k < outcomes && !stopped; k++) {
            double p = mdp.outcome(level.predicted, k, level.outcome);
            if (p > 0) {
                future += p * outcomeValue(level, horizon, seed);
            }
        }
        return reward + mdp.discount() * future;
    }

    private double outcomeValue(Level<N> level, int horizon, long seed) {
        if (mdp.acts(level.outcome) == 0) {
            return 0;
        }
        if (!mdp.sampled(level.outcome)) {
            return value(level.outcome, horizon - 1, seed);
        }
        double sum = 0;
        for (int c = 0; c < width && !stopped; c++) {
            long sample = Streams.mix(seed, c);
            random.seed(sample);
            mdp.sample(level.outcome, (c + random.nextDouble()) / width, random, level.next);
            sum += value(level.next, horizon - 1, sample);
        }
        return sum / width;
    }
}
