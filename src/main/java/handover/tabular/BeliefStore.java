package handover.tabular;

import handover.math.Streams;
import java.util.Arrays;

/**
 * Beliefs as numbers, each stored once: what is found again has the same number, however it was reached. Two beliefs are the
 * same if they agree in every probability up to {@link #SAME}; they are looked up by a hash of their probabilities rounded to
 * {@link #GRID}, so that two that lie on different sides of a rounding step may be kept apart, which costs time but no
 * correctness. Only what is not 0 is stored. Used by one thread.
 */
final class BeliefStore {
    static final double SAME = 1e-11;
    private static final double GRID = 1L << 30;

    private final int states;
    private int[] begin = new int[1025];
    private int[] state = new int[8192];
    private double[] probability = new double[8192];
    private int[] slots = new int[4096];
    private long[] hashes = new long[1025];
    private int size;

    BeliefStore(int states) {
        this.states = states;
        Arrays.fill(slots, -1);
    }

    int size() {
        return size;
    }

    /** Forgets all, keeps the space. */
    void clear() {
        size = 0;
        Arrays.fill(slots, -1);
    }

    /** Where the states and probabilities of belief {@code k} begin; those of the next one are its end. */
    int begin(int k) {
        return begin[k];
    }

    int[] states() {
        return state;
    }

    double[] probabilities() {
        return probability;
    }

    /** The number of a belief, new ({@link #size} before) if it was not stored yet; not modified. */
    int number(double[] belief) {
        long hash = 0;
        for (int s = 0; s < states; s++) {
            if (belief[s] > 0) {
                hash = Streams.mix(hash + s, Math.round(belief[s] * GRID));
            }
        }
        int mask = slots.length - 1;
        int at = (int) hash & mask;
        while (slots[at] >= 0) {
            if (hashes[slots[at]] == hash && same(slots[at], belief)) {
                return slots[at];
            }
            at = (at + 1) & mask;
        }
        slots[at] = size;
        add(belief, hash);
        return size - 1;
    }

    private boolean same(int k, double[] belief) {
        double rest = 1;
        for (int i = begin[k]; i < begin[k + 1]; i++) {
            if (Math.abs(probability[i] - belief[state[i]]) > SAME) {
                return false;
            }
            rest -= belief[state[i]];
        }
        return rest <= states * SAME;
    }

    private void add(double[] belief, long hash) {
        if (size + 2 > begin.length) {
            begin = Arrays.copyOf(begin, 2 * begin.length);
            hashes = Arrays.copyOf(hashes, 2 * hashes.length);
        }
        int at = begin[size];
        if (at + states > state.length) {
            int room = Math.max(2 * state.length, at + states);
            state = Arrays.copyOf(state, room);
            probability = Arrays.copyOf(probability, room);
        }
        for (int s = 0; s < states; s++) {
            if (belief[s] > 0) {
                state[at] = s;
                probability[at++] = belief[s];
            }
        }
        hashes[size] = hash;
        begin[++size] = at;
        if (2 * size > slots.length) {
            rehash();
        }
    }

    private void rehash() {
        slots = new int[2 * slots.length];
        Arrays.fill(slots, -1);
        int mask = slots.length - 1;
        for (int k = 0; k < size; k++) {
            int at = (int) hashes[k] & mask;
            while (slots[at] >= 0) {
                at = (at + 1) & mask;
            }
            slots[at] = k;
        }
    }

    /** What is believed after an act at belief {@code k}, before anything is observed; {@code out} is modified. */
    void predict(int k, TabularPomdp m, int a, double[] out) {
        Arrays.fill(out, 0);
        for (int i = begin[k]; i < begin[k + 1]; i++) {
            m.spread(a, state[i], probability[i], out);
        }
    }

    /** Writes belief {@code k} into an array of zeros; modified. */
    void scatter(int k, double[] dense) {
        for (int i = begin[k]; i < begin[k + 1]; i++) {
            dense[state[i]] = probability[i];
        }
    }

    /** Puts the zeros back after {@link #scatter}; modified. */
    void unscatter(int k, double[] dense) {
        for (int i = begin[k]; i < begin[k + 1]; i++) {
            dense[state[i]] = 0;
        }
    }

    /** The product of belief {@code k} with a vector that begins at {@code at}. */
    double dot(int k, double[] vector, int at) {
        double v = 0;
        for (int i = begin[k]; i < begin[k + 1]; i++) {
            v += probability[i] * vector[at + state[i]];
        }
        return v;
    }
}
