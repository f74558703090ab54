package handover.solver;

import handover.math.SeededRandom;

/**
 * Draws of what an act is worth if {@link BeliefMdp#simple} goes on from there for some acts, on sampled observations, and then
 * the leaf's policy: the rollout algorithm of Bertsekas and Castanon, "Rollout algorithms for stochastic scheduling problems"
 * (1999), with one base policy that listens. Used by one thread at a time.
 *
 * @param <N> node of the problem
 */
final class Rollouts<N> implements Draws<N> {
    /** Acts that are played; what comes later is worth the leaf. */
    private static final int LONGEST = 10;

    private final BeliefMdp<N> mdp;
    private final N predicted;
    private final N outcome;
    private final N next;
    private final SeededRandom random = new SeededRandom();
    private long nodes;

    Rollouts(BeliefMdp<N> mdp) {
        this.mdp = mdp;
        predicted = mdp.node();
        outcome = mdp.node();
        next = mdp.node();
    }

    @Override
    public long nodes() {
        return nodes;
    }

    @Override
    public double draw(N root, int act, double stratum, long seed, Deadline limit) {
        random.seed(seed);
        double value = mdp.start(root, act, predicted);
        double discount = mdp.discount();
        double level = stratum;
        for (int k = 1; k < LONGEST; k++) {
            if (!observe(level)) {
                return value;
            }
            nodes++;
            value += discount * mdp.start(next, mdp.simple(next), predicted);
            discount *= mdp.discount();
            level = random.nextDouble();
        }
        return value + discount * mdp.leaf(predicted);
    }

    /** Draws an outcome and what is observed then, into {@code next}; false if that is the end. */
    private boolean observe(double level) {
        double u = random.nextDouble();
        int last = mdp.outcomes(predicted) - 1;
        double p = mdp.outcome(predicted, 0, outcome);
        for (int k = 0; k < last && (u -= p) >= 0; k++) {
            p = mdp.outcome(predicted, k + 1, outcome);
        }
        if (mdp.acts(outcome) == 0) {
            return false;
        }
        mdp.sampled(outcome);
        mdp.sample(outcome, level, random, next);
        return true;
    }
}
