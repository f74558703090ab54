package handover.tabular;

import java.util.Arrays;
import java.util.List;

/**
 * A POMDP with finitely many states, acts and observations, as flat arrays: T(s' | s, a), O(o | a, s'), R(s, a, s', o), a
 * discount and a belief to start from. Made by {@link TabularBuilder}. Immutable, thread safe.
 */
public final class TabularPomdp {
    private final double discount;
    private final List<String> states;
    private final List<String> acts;
    private final List<String> observations;
    private final double[] start;
    private final RewardTable[] rewards;
    /** Where the row of T of act a and state s begins: at a * S + s; one more at the end. */
    final int[] row;
    /** By entry of T: s'. */
    final int[] next;
    /** By entry of T: its probability, above 0. */
    final double[] probability;
    /** O by act, observation, s'. */
    final double[] sensed;
    /** Expected reward by act and state. */
    final double[] reward;
    private final boolean[] terminal;

    TabularPomdp(TabularBuilder b) {
        discount = b.discount();
        states = b.states();
        acts = b.acts();
        observations = b.observations();
        start = b.start();
        rewards = b.rewards();
        int entries = 0;
        for (int a = 0; a < acts.size(); a++) {
            for (double p : b.transitions(a)) {
                entries += p > 0 ? 1 : 0;
            }
        }
        row = new int[acts.size() * states.size() + 1];
        next = new int[entries];
        probability = new double[entries];
        sensed = new double[acts.size() * observations.size() * states.size()];
        reward = new double[acts.size() * states.size()];
        for (int a = 0; a < acts.size(); a++) {
            fill(a, b.transitions(a), b.senses(a));
        }
        terminal = new boolean[states.size()];
        for (int s = 0; s < terminal.length; s++) {
            terminal[s] = absorbs(s);
        }
    }

    private void fill(int a, double[] transition, double[] senses) {
        int n = states.size();
        int m = observations.size();
        int k = row[a * n];
        for (int s = 0; s < n; s++) {
            for (int to = 0; to < n; to++) {
                if (transition[s * n + to] > 0) {
                    next[k] = to;
                    probability[k++] = transition[s * n + to];
                }
            }
            row[a * n + s + 1] = k;
        }
        for (int to = 0; to < n; to++) {
            for (int o = 0; o < m; o++) {
                sensed[(a * m + o) * n + to] = senses[to * m + o];
            }
        }
        for (int s = 0; s < n; s++) {
            reward[a * n + s] = expectedReward(a, s);
        }
    }

    private double expectedReward(int a, int s) {
        if (!rewards[a].dependsOnNext()) {
            return rewards[a].get(s, 0, 0);
        }
        double r = 0;
        for (int k = row[a * states.size() + s]; k < row[a * states.size() + s + 1]; k++) {
            double here = 0;
            for (int o = 0; o < (rewards[a].dependsOnObservation() ? observations.size() : 0); o++) {
                here += observation(a, next[k], o) * rewards[a].get(s, next[k], o);
            }
            r += probability[k] * (rewards[a].dependsOnObservation() ? here : rewards[a].get(s, next[k], 0));
        }
        return r;
    }

    private boolean absorbs(int s) {
        for (int a = 0; a < acts.size(); a++) {
            int at = a * states.size() + s;
            if (row[at + 1] - row[at] != 1 || next[row[at]] != s || reward[at] != 0 || paid(a, s)) {
                return false;
            }
        }
        return true;
    }

    private boolean paid(int a, int s) {
        for (int o = 0; o < observations.size(); o++) {
            if (observation(a, s, o) > 0 && reward(a, s, s, o) != 0) {
                return true;
            }
        }
        return false;
    }

    /** gamma, in [0, 1]. */
    public double discount() {
        return discount;
    }

    public List<String> states() {
        return states;
    }

    public List<String> acts() {
        return acts;
    }

    public List<String> observations() {
        return observations;
    }

    /** The belief to start from, a copy. */
    public double[] start() {
        return start.clone();
    }

    /** T(next | s, a). */
    public double transition(int a, int s, int to) {
        int at = a * states.size() + s;
        int k = Arrays.binarySearch(next, row[at], row[at + 1], to);
        return k < 0 ? 0 : probability[k];
    }

    /** O(o | a, next). */
    public double observation(int a, int to, int o) {
        return sensed[(a * observations.size() + o) * states.size() + to];
    }

    /** R(s, a, next, o). */
    public double reward(int a, int s, int to, int o) {
        return rewards[a].get(s, to, o);
    }

    /** The reward of an act in a state, in expectation over what follows. */
    public double reward(int a, int s) {
        return reward[a * states.size() + s];
    }

    /** Whether R of this act depends on the next state, or also on the observation. */
    public boolean rewardDependsOnNext(int a) {
        return rewards[a].dependsOnNext();
    }

    /** Whether R of this act depends on the observation. */
    public boolean rewardDependsOnObservation(int a) {
        return rewards[a].dependsOnObservation();
    }

    /** Whether every act stays in this state and nothing more is earned. */
    public boolean terminal(int s) {
        return terminal[s];
    }

    /** Whether the episode is over as far as a belief can tell: all of it is on terminal states. */
    public boolean over(double[] belief) {
        for (int s = 0; s < belief.length; s++) {
            if (belief[s] > 0 && !terminal[s]) {
                return false;
            }
        }
        return true;
    }

    /**
     * What is believed after an act, before anything is observed.
     *
     * @param belief not modified
     * @param out another array; modified
     */
    public void predict(double[] belief, int a, double[] out) {
        Arrays.fill(out, 0);
        for (int s = 0; s < belief.length; s++) {
            if (belief[s] > 0) {
                spread(a, s, belief[s], out);
            }
        }
    }

    /** Adds p T(s' | s, a) for each s' to {@code out}; modified. */
    void spread(int a, int s, double p, double[] out) {
        int at = a * states.size() + s;
        for (int k = row[at]; k < row[at + 1]; k++) {
            out[next[k]] += p * probability[k];
        }
    }

    /**
     * Bayes' rule for an observation.
     *
     * @param predicted as by {@link #predict}; not modified
     * @param out another array; modified, of no meaning if the observation cannot be
     * @return the probability of the observation
     */
    public double correct(double[] predicted, int a, int o, double[] out) {
        int at = (a * observations.size() + o) * predicted.length;
        double p = 0;
        for (int s = 0; s < predicted.length; s++) {
            out[s] = predicted[s] * sensed[at + s];
            p += out[s];
        }
        for (int s = 0; s < predicted.length && p > 0; s++) {
            out[s] /= p;
        }
        return p;
    }

    /** The observation at {@code level} (in [0, 1)) of the cumulative sums of O(. | a, to); never one of probability 0. */
    int observed(int a, int to, double level) {
        int last = -1;
        double left = level;
        for (int o = 0; o < observations.size() && left >= 0; o++) {
            double p = observation(a, to, o);
            last = p > 0 ? o : last;
            left -= p;
        }
        return last;
    }

    /** sum_s belief(s) values(a, s), for an array by act and state. */
    static double dot(double[] belief, double[] values, int from) {
        double v = 0;
        for (int s = 0; s < belief.length; s++) {
            v += belief[s] * values[from + s];
        }
        return v;
    }
}
