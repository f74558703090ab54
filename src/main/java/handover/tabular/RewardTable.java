package handover.tabular;

import java.util.Arrays;

/**
 * R(s, a, s', o) of one act, kept as small as what it depends on: s alone, s and s', or all three. Grows while a model is
 * built; not modified after that.
 */
final class RewardTable {
    private final int states;
    private final int observations;
    /** By s; or by s, s'; or by s, s', o. */
    private double[] value;

    RewardTable(int states, int observations) {
        this.states = states;
        this.observations = observations;
        this.value = new double[states];
    }

    boolean dependsOnNext() {
        return value.length > states;
    }

    boolean dependsOnObservation() {
        return value.length > states * states;
    }

    /** Numbers kept once an entry with this much detail is set. */
    long cells(boolean next, boolean observation) {
        long wanted = observation ? (long) states * states * observations : next ? (long) states * states : states;
        return Math.max(value.length, wanted);
    }

    double get(int s, int next, int o) {
        if (dependsOnObservation()) {
            return value[(s * states + next) * observations + o];
        }
        return dependsOnNext() ? value[s * states + next] : value[s];
    }

    /** Sets one entry, or many where an index is negative. */
    void set(int s, int next, int o, double r) {
        if (next >= 0 && !dependsOnNext()) {
            value = spread(value, states);
        }
        if (o >= 0 && !dependsOnObservation()) {
            value = spread(dependsOnNext() ? value : spread(value, states), observations);
        }
        for (int from = s < 0 ? 0 : s; from <= (s < 0 ? states - 1 : s); from++) {
            setFrom(from, next, o, r);
        }
    }

    private void setFrom(int s, int next, int o, double r) {
        int width = value.length / states;
        if (next < 0 && o < 0) {
            Arrays.fill(value, s * width, (s + 1) * width, r);
            return;
        }
        int each = width / states;
        for (int to = next < 0 ? 0 : next; to <= (next < 0 ? states - 1 : next); to++) {
            int at = s * width + to * each;
            if (o < 0) {
                Arrays.fill(value, at, at + each, r);
            } else {
                value[at + o] = r;
            }
        }
    }

    private static double[] spread(double[] from, int times) {
        double[] to = new double[from.length * times];
        for (int i = 0; i < from.length; i++) {
            Arrays.fill(to, i * times, (i + 1) * times, from[i]);
        }
        return to;
    }
}
