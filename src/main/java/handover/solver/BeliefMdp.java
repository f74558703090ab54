package handover.solver;

import java.util.random.RandomGenerator;

/**
 * A POMDP as a search sees it: beliefs are reusable nodes, and an act is a reward, an expected next belief, and outcomes
 * to weigh or to sample. Implementations are used by one thread at a time and allocate nothing after warm-up.
 *
 * @param <N> a node: a belief with the known part, or what is in between an act and its observation
 */
public interface BeliefMdp<N> {
    /** A node to be filled by this problem. */
    N node();

    double discount();

    /** How many acts are legal; 0 if the episode is over. */
    int acts(N node);

    /**
     * Starts an act: its expected reward now, which may depend on the belief.
     *
     * @param next receives the prediction: what is believed before anything is observed; modified
     */
    double start(N node, int act, N next);

    /** Into how many outcomes of known probability what follows is split. */
    int outcomes(N predicted);

    /**
     * One outcome; an outcome of probability 0 leaves {@code next} undefined.
     *
     * @return its probability
     */
    double outcome(N predicted, int k, N next);

    /** Whether an outcome leaves something to observe that must be sampled. */
    boolean sampled(N outcome);

    /**
     * Draws an observation of an outcome and corrects the belief by it.
     *
     * @param stratum in [0, 1): which part of the distribution of hidden states the draw comes from, so that several draws
     *     can be spread evenly over it
     */
    void sample(N outcome, double stratum, RandomGenerator random, N next);

    /** What some simple policy earns after an act, before anything is observed. */
    double leaf(N predicted);

    /** How much an act has to do with what is thought likely: where there are too many acts to try all, those with most are tried. */
    default double relevance(N node, int act) {
        return 0;
    }

    /** The act of some simple policy that listens to what is observed, for rollouts; -1 if none is known that leaves do not value. */
    default int simple(N node) {
        return -1;
    }

    /**
     * An upper bound on what an act can be worth, however far the search looks and whatever it samples, by which acts are left
     * out; infinity if none is known.
     */
    default double bound(N node, int act) {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * The value of the best act if nothing is looked at after it. A problem that knows bounds may leave out acts that cannot
     * be the best; the value is the same to the last bit.
     *
     * @param leaves whether what comes after the act is worth its {@link #leaf}, or 0
     * @param next for its own use; modified
     */
    default double last(N node, boolean leaves, N next) {
        double best = Double.NEGATIVE_INFINITY;
        int acts = acts(node);
        for (int a = 0; a < acts; a++) {
            best = Math.max(best, ending(start(node, a, next), leaves, next));
        }
        return best;
    }

    /** The value of an act after which nothing is looked at. */
    default double ending(double reward, boolean leaves, N predicted) {
        return reward + (leaves ? discount() * leaf(predicted) : 0);
    }
}
