package handover.solver;

import handover.math.Simplex;

/** b in a search, with what is computed from it once. Used by one thread at a time. */
final class SearchBelief {
    final double[] p;
    private int n;
    private int likeliest;
    /** The object whose rejection {@link #afterRejection} is about, -1 if none was asked for yet. */
    int rejected;
    double afterRejection;
    /** The match reward if the human expects nothing in particular; NaN until asked for. */
    double matchUniform;
    /** The best match reward whatever the human expects; NaN until asked for. */
    double matchBound;
    /** The value of {@link AskInTurn}; NaN until asked for. */
    double asking;
    /** The value of {@link ReachInTurn}; NaN until asked for. */
    double reaching;
    /** Upper bound on what may follow an act that is no pick; NaN until asked for. */
    double bound;
    /** Upper bound on handing over the likeliest object now; NaN until asked for. */
    double commitBound;

    SearchBelief(int capacity) {
        p = new double[capacity];
    }

    /** Starts a new belief from {@code from}, which may then be changed until something is asked of it. */
    SearchBelief begin(double[] from, int size) {
        System.arraycopy(from, 0, p, 0, size);
        n = size;
        likeliest = -1;
        rejected = -1;
        matchUniform = Double.NaN;
        matchBound = Double.NaN;
        asking = Double.NaN;
        reaching = Double.NaN;
        bound = Double.NaN;
        commitBound = Double.NaN;
        return this;
    }

    int likeliest() {
        if (likeliest < 0) {
            likeliest = Simplex.argmax(p, n);
        }
        return likeliest;
    }
}
