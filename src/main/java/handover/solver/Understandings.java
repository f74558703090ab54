package handover.solver;

import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import java.util.Arrays;

/** beta' after each act that each of a list of minds may perceive, filled on demand. Used by one thread at a time. */
final class Understandings {
    private final HandoverDomain domain;
    private Entry[][] entries = new Entry[0][];
    private int current;

    Understandings(HandoverDomain domain) {
        this.domain = domain;
    }

    /** beta' and S(e_i, beta') for each object i. */
    static final class Entry {
        final double[] human;
        private final double[] score;
        private int filled = -1;
        private boolean scored;

        private Entry(int capacity) {
            human = new double[capacity];
            score = new double[capacity];
        }

        /** sum_i row(i) S(e_i, beta'), the expected match reward of a score of states. */
        double score(HandoverDomain domain, double[] row, int n, double[] vertex) {
            if (!scored) {
                scored = true;
                Arrays.fill(vertex, 0);
                for (int i = 0; i < n; i++) {
                    vertex[i] = 1;
                    score[i] = domain.matchReward(vertex, human, n);
                    vertex[i] = 0;
                }
            }
            double sum = 0;
            for (int i = 0; i < n; i++) {
                sum += row[i] * score[i];
            }
            return sum;
        }
    }

    /** For other minds from now on. */
    void reset() {
        current++;
    }

    /**
     * What mind {@code k} believes after an act.
     *
     * @param beta what it believed, always the same between two {@link #reset}; not modified
     */
    Entry after(int k, ActModel act, double[] beta) {
        if (k >= entries.length) {
            entries = Arrays.copyOf(entries, 2 * k + 1);
        }
        int a = act.index();
        if (entries[k] == null || a >= entries[k].length) {
            entries[k] = entries[k] == null ? new Entry[a + 1] : Arrays.copyOf(entries[k], a + 1);
        }
        Entry e = entries[k][a];
        int n = act.lambda().length;
        if (e == null || e.human.length < n) {
            e = new Entry(n);
            entries[k][a] = e;
        }
        if (e.filled != current) {
            domain.understand(act, beta, e.human, n);
            e.filled = current;
            e.scored = false;
        }
        return e;
    }
}
