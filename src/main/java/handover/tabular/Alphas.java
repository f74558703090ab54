package handover.tabular;

import java.util.Arrays;

/**
 * A set of vectors over states, each with the act that it begins with; the largest of their products with a belief bounds its
 * value from below. Only grows. Used by one thread while it is written to.
 */
final class Alphas {
    private final int states;
    private double[] value;
    private int[] act;
    /** The same numbers by state: value s of vector k is at s * capacity + k, so that many vectors are compared at once. */
    private double[] column;
    private int size;

    Alphas(int states) {
        this.states = states;
        this.value = new double[16 * states];
        this.act = new int[16];
        this.column = new double[16 * states];
    }

    /** The same vectors, to grow apart. */
    Alphas copy() {
        Alphas other = new Alphas(states);
        other.value = value.clone();
        other.act = act.clone();
        other.column = column.clone();
        other.size = size;
        return other;
    }

    int states() {
        return states;
    }

    int size() {
        return size;
    }

    int act(int k) {
        return act[k];
    }

    /** Forgets all but the first {@code n}. */
    void truncate(int n) {
        size = Math.min(size, n);
    }

    /** Where vector k begins in {@link #values}. */
    int at(int k) {
        return k * states;
    }

    double[] values() {
        return value;
    }

    void add(double[] from, int at, int firstAct) {
        if (size == act.length) {
            value = Arrays.copyOf(value, 2 * value.length);
            act = Arrays.copyOf(act, 2 * size);
            widen();
        }
        System.arraycopy(from, at, value, size * states, states);
        for (int s = 0; s < states; s++) {
            column[s * act.length + size] = from[at + s];
        }
        act[size++] = firstAct;
    }

    private void widen() {
        double[] wider = new double[act.length * states];
        for (int s = 0; s < states; s++) {
            System.arraycopy(column, s * size, wider, s * act.length, size);
        }
        column = wider;
    }

    /**
     * Adds p times what the vectors say of a state.
     *
     * @param out by vector, from {@code first} on; modified
     */
    void accumulate(int state, double p, int first, double[] out) {
        int at = state * act.length;
        for (int k = first; k < size; k++) {
            out[k] += p * column[at + k];
        }
    }

    /** How many vectors fit in before the space grows. */
    int capacity() {
        return act.length;
    }

    /** The index of the best vector at a belief. */
    int best(double[] belief) {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < size; k++) {
            double v = TabularPomdp.dot(belief, value, k * states);
            if (v > most) {
                most = v;
                best = k;
            }
        }
        return best;
    }

    double value(double[] belief) {
        return TabularPomdp.dot(belief, value, at(best(belief)));
    }

    /** A new set without those vectors that another one is nowhere below. */
    Alphas pruned() {
        Alphas kept = new Alphas(states);
        for (int k = 0; k < size; k++) {
            boolean needed = true;
            for (int other = 0; other < size && needed; other++) {
                needed = other == k || !covers(other, k);
            }
            if (needed) {
                kept.add(value, at(k), act[k]);
            }
        }
        return kept;
    }

    /** Whether one vector is nowhere below another; of two equal ones the first covers. */
    private boolean covers(int other, int k) {
        boolean above = false;
        for (int s = 0; s < states; s++) {
            double d = value[at(other) + s] - value[at(k) + s];
            if (d < 0) {
                return false;
            }
            above |= d > 0;
        }
        return above || other < k;
    }
}
