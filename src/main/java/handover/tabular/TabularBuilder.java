package handover.tabular;

import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;

/** Collects the numbers of one {@link TabularPomdp}. What is set later counts. Used once, by one thread. */
public final class TabularBuilder {
    /** Numbers that a model may have: more would not fit into an ordinary heap. */
    public static final long MOST_CELLS = 40_000_000;
    /** How far the sum of a row may be from 1; files have few digits. */
    public static final double TOLERANCE = 1e-5;
    /** Rows closer to 1 than this are left as they are, so that what was written is read back the same. */
    private static final double ROUNDING = 1e-12;

    private final double discount;
    private final List<String> states;
    private final List<String> acts;
    private final List<String> observations;
    private double[] start;
    private final double[][] transition;
    private final double[][] sense;
    private final RewardTable[] rewards;

    /** What kind of row of probabilities something is. */
    public enum Kind {
        START, TRANSITION, OBSERVATION
    }

    /**
     * Probabilities that do not sum to 1.
     *
     * @param act 0 for the start
     * @param state of departure for a transition, of arrival for an observation, 0 for the start
     */
    public record BadRow(Kind kind, int act, int state, double sum) {}

    /**
     * Begins with the uniform start, and with no probability and no reward anywhere.
     *
     * @param discount in [0, 1]
     * @param states names, at least one; likewise acts and observations
     * @throws IllegalArgumentException if a list is empty or names something twice, or if the model would be too large
     */
    public TabularBuilder(double discount, List<String> states, List<String> acts, List<String> observations) {
        if (!(discount >= 0 && discount <= 1)) {
            throw new IllegalArgumentException("discount: expected a number in [0, 1], got " + discount);
        }
        checkNames("states", states);
        checkNames("actions", acts);
        checkNames("observations", observations);
        this.discount = discount;
        this.states = List.copyOf(states);
        this.acts = List.copyOf(acts);
        this.observations = List.copyOf(observations);
        int n = states.size();
        checkSize((long) acts.size() * n * ((long) n + observations.size()));
        start = new double[n];
        Arrays.fill(start, 1.0 / n);
        transition = new double[acts.size()][n * n];
        sense = new double[acts.size()][n * observations.size()];
        rewards = new RewardTable[acts.size()];
        Arrays.setAll(rewards, a -> new RewardTable(n, observations.size()));
    }

    private static void checkNames(String what, List<String> names) {
        if (names.isEmpty() || new HashSet<>(names).size() < names.size()) {
            String twice = names.stream().filter(x -> Collections.frequency(names, x) > 1).findFirst().orElse("none");
            throw new IllegalArgumentException(what + ": expected at least one name and each once, got " + twice
                    + (names.isEmpty() ? "" : " twice"));
        }
    }

    private static void checkSize(long cells) {
        if (cells > MOST_CELLS) {
            throw new IllegalArgumentException("expected a model of at most " + MOST_CELLS + " numbers, got " + cells);
        }
    }

    /** Sets b_0; copied. */
    public void start(double[] belief) {
        start = belief.clone();
    }

    public void transition(int a, int s, int to, double p) {
        transition[a][s * states.size() + to] = p;
    }

    public double transition(int a, int s, int to) {
        return transition[a][s * states.size() + to];
    }

    public void observation(int a, int to, int o, double p) {
        sense[a][to * observations.size() + o] = p;
    }

    public double observation(int a, int to, int o) {
        return sense[a][to * observations.size() + o];
    }

    /**
     * Sets R(s, a, next, o); a negative index stands for all, but not for all acts.
     *
     * @throws IllegalArgumentException if this much detail makes the model too large
     */
    public void reward(int a, int s, int to, int o, double r) {
        long cells = rewards[a].cells(to >= 0, o >= 0);
        for (int other = 0; other < rewards.length; other++) {
            cells += other == a ? 0 : rewards[other].cells(false, false);
        }
        checkSize(cells);
        rewards[a].set(s, to, o, r);
    }

    /** The first row whose probabilities do not sum to 1 up to {@link #TOLERANCE}; null if there is none. */
    public BadRow badRow() {
        if (!sumsToOne(start, 0, start.length)) {
            return new BadRow(Kind.START, 0, 0, sum(start, 0, start.length));
        }
        for (int a = 0; a < acts.size(); a++) {
            for (Kind kind : new Kind[] {Kind.TRANSITION, Kind.OBSERVATION}) {
                double[] rows = kind == Kind.TRANSITION ? transition[a] : sense[a];
                int width = rows.length / states.size();
                for (int s = 0; s < states.size(); s++) {
                    if (!sumsToOne(rows, s * width, width)) {
                        return new BadRow(kind, a, s, sum(rows, s * width, width));
                    }
                }
            }
        }
        return null;
    }

    private static boolean sumsToOne(double[] p, int from, int width) {
        return Math.abs(sum(p, from, width) - 1) <= TOLERANCE;
    }

    private static double sum(double[] p, int from, int width) {
        double s = 0;
        for (int i = from; i < from + width; i++) {
            s += p[i];
        }
        return s;
    }

    /** The model. Throws {@link IllegalArgumentException} if there is a {@link #badRow}. */
    public TabularPomdp build() {
        BadRow bad = badRow();
        if (bad != null) {
            throw new IllegalArgumentException(String.format(Locale.ROOT, "%s: expected probabilities that sum to 1, got a sum of %s",
                    describe(bad), bad.sum));
        }
        normalise(start, start.length);
        for (int a = 0; a < acts.size(); a++) {
            normalise(transition[a], states.size());
            normalise(sense[a], observations.size());
        }
        return new TabularPomdp(this);
    }

    /** A row as a file writes it: {@code T: listen : tiger-left}. */
    public String describe(BadRow row) {
        return row.kind == Kind.START ? "start" : (row.kind == Kind.TRANSITION ? "T: " : "O: ") + acts.get(row.act) + " : "
                + states.get(row.state);
    }

    private static void normalise(double[] rows, int width) {
        for (int from = 0; from < rows.length; from += width) {
            double sum = sum(rows, from, width);
            double scale = Math.abs(sum - 1) > ROUNDING ? sum : 1;
            for (int i = from; i < from + width; i++) {
                rows[i] = Math.min(1, rows[i] / scale);
            }
        }
    }

    double discount() {
        return discount;
    }

    List<String> states() {
        return states;
    }

    List<String> acts() {
        return acts;
    }

    List<String> observations() {
        return observations;
    }

    double[] start() {
        return start.clone();
    }

    /** By state and next state. */
    double[] transitions(int a) {
        return transition[a];
    }

    /** By next state and observation. */
    double[] senses(int a) {
        return sense[a];
    }

    RewardTable[] rewards() {
        return rewards;
    }
}
