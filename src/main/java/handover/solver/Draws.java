package handover.solver;

/** A way to draw what an act is worth. Used by one thread at a time. */
interface Draws<N> {
    /**
     * One draw.
     *
     * @param stratum in [0, 1): which part of the distribution of hidden states the first observation comes from
     * @return NaN if the deadline passed first
     */
    double draw(N root, int act, double stratum, long seed, Deadline limit);

    /** Beliefs visited since construction. */
    long nodes();
}
