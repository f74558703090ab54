package handover.contract;

import handover.solver.BeliefMdp;
import java.util.random.RandomGenerator;

/** A belief MDP without the bound of another one, so that nothing is left out. */
public record Unbounded<N>(BeliefMdp<N> mdp) implements BeliefMdp<N> {
    @Override
    public N node() {
        return mdp.node();
    }

    @Override
    public double discount() {
        return mdp.discount();
    }

    @Override
    public int acts(N node) {
        return mdp.acts(node);
    }

    @Override
    public double start(N node, int act, N next) {
        return mdp.start(node, act, next);
    }

    @Override
    public int outcomes(N predicted) {
        return mdp.outcomes(predicted);
    }

    @Override
    public double outcome(N predicted, int k, N next) {
        return mdp.outcome(predicted, k, next);
    }

    @Override
    public boolean sampled(N outcome) {
        return mdp.sampled(outcome);
    }

    @Override
    public void sample(N outcome, double stratum, RandomGenerator random, N next) {
        mdp.sample(outcome, stratum, random, next);
    }

    @Override
    public double leaf(N predicted) {
        return mdp.leaf(predicted);
    }
}
