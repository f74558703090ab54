package handover.theory;

import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What {@code Self} believes about the other's choice iota <em>and</em> about the other's belief beta, together: weights
 * p(iota, beta_k) over finitely many beta_k. It is needed once an answer depends on both what is wanted and what was
 * perceived: "no" means not this one, or misheard. Exact until more than {@code limit} beliefs are possible, then as
 * {@link Clusters}; without misperception there is one belief, and it is the filter of MODEL 4.4. Immutable, thread safe;
 * arrays must not be modified.
 *
 * @param points the possible beta, each over n objects and summing to one
 * @param weights one row per beta, p(iota, beta_k), n entries each; all together summing to one
 * @param limit how many beliefs are kept, at least 1
 * @param <Self> who holds it, and whose choice beta is about
 * @param <Other> who holds beta, and whose choice iota is
 */
public record JointBelief<Self extends Agent<Self, Other>, Other extends Agent<Other, Self>>(List<double[]> points,
        List<double[]> weights, int limit) {
    /** Throws {@link IllegalArgumentException} if sizes differ or the limit is not positive. */
    public JointBelief {
        points = List.copyOf(points);
        weights = List.copyOf(weights);
        Weights.sameSize("rows of weights", points.size(), weights.size());
        if (limit < 1) {
            throw new IllegalArgumentException("limit: expected at least 1 belief, got " + limit);
        }
    }

    /** b and a known beta, independent. */
    public static <S extends Agent<S, O>, O extends Agent<O, S>> JointBelief<S, O> of(Categorical<O> b, Categorical<S> beta,
            int limit) {
        Weights.sameSize("belief", beta.size(), b.size());
        return new JointBelief<>(List.of(beta.probabilities()), List.of(b.probabilities()), limit);
    }

    /** b(iota), the categorical level. */
    public Categorical<Other> belief() {
        double[] b = new double[points.get(0).length];
        for (double[] row : weights) {
            for (int i = 0; i < b.length; i++) {
                b[i] += row[i];
            }
        }
        Simplex.normalise(b, b.length);
        return new Categorical<>(b);
    }

    /** B(beta), the level above. */
    public Atoms<Self> nested() {
        double[] w = weights.stream().mapToDouble(row -> Simplex.sum(row, row.length)).toArray();
        Simplex.normalise(w, w.length);
        return new Atoms<>(w, points);
    }

    /** Both choices may have moved: iota by {@code other}, what beta is about by {@code own}. */
    public JointBelief<Self, Other> predicted(Transition<Self> own, Transition<Other> other) {
        List<double[]> rows = weights.stream().map(other::moved).toList();
        return new JointBelief<>(points.stream().map(own::moved).toList(), rows, limit);
    }

    /**
     * An act, and what it made the other do.
     *
     * @param act what may have been perceived
     * @param likelihood p(e | iota, a~), one row per perceived act, one entry per iota; {@code null} if nothing was
     *     sensed. If more comes later in the same step, start again from before the act with the product.
     * @return the posterior; without the evidence if it was impossible (MODEL 4.3)
     */
    public JointBelief<Self, Other> perceived(Perception<Self> act, double[][] likelihood) {
        List<double[]> beliefs = new ArrayList<>();
        List<double[]> rows = new ArrayList<>();
        for (int a = 0; a < act.size(); a++) {
            for (int k = 0; k < points.size(); k++) {
                double[] row = weights.get(k).clone();
                for (int i = 0; i < row.length; i++) {
                    row[i] *= act.probabilities()[a] * (likelihood == null ? 1 : likelihood[a][i]);
                }
                beliefs.add(Categorical.corrected(points.get(k), act.messages().get(a).likelihood()));
                rows.add(row);
            }
        }
        return total(rows) > 0 ? new JointBelief<Self, Other>(beliefs, rows, limit).merged() : perceived(act, null);
    }

    /** What was sensed says something about iota alone; unchanged if it was impossible. */
    public JointBelief<Self, Other> given(Message<Other> message) {
        return weighted((i, beta) -> message.likelihood()[i]);
    }

    /**
     * The other did something that depends on what it wants and on what it believes, for instance spoke up because the
     * wanted object is not expected; unchanged if it was impossible.
     *
     * @param evidence p(e | iota, beta) for each iota
     */
    public JointBelief<Self, Other> given(List<Evidence<Self>> evidence) {
        return weighted((i, beta) -> evidence.get(i).given(beta));
    }

    /** p(e | iota, beta). */
    private interface Likelihood {
        double of(int i, double[] beta);
    }

    private JointBelief<Self, Other> weighted(Likelihood likelihood) {
        List<double[]> rows = new ArrayList<>();
        for (int k = 0; k < points.size(); k++) {
            double[] row = weights.get(k).clone();
            for (int i = 0; i < row.length; i++) {
                row[i] *= likelihood.of(i, points.get(k));
            }
            rows.add(row);
        }
        return total(rows) > 0 ? new JointBelief<Self, Other>(points, rows, limit).normalised() : this;
    }

    /** Equal beliefs put together, then near ones if they are too many. */
    private JointBelief<Self, Other> merged() {
        JointBelief<Self, Other> exact = grouped(Merging.groups(points));
        if (exact.points.size() <= limit) {
            return exact;
        }
        return exact.grouped(Clustering.groups(exact.nested().weights(), exact.points, limit));
    }

    /** Rows added up and beliefs averaged within each group; groups without weight are left out. */
    private JointBelief<Self, Other> grouped(int[] group) {
        int n = points.get(0).length;
        int count = Arrays.stream(group).max().orElse(-1) + 1;
        double[][] means = new double[count][n];
        double[][] rows = new double[count][n];
        for (int k = 0; k < group.length; k++) {
            double w = Simplex.sum(weights.get(k), n);
            for (int i = 0; i < n; i++) {
                means[group[k]][i] += w * points.get(k)[i];
                rows[group[k]][i] += weights.get(k)[i];
            }
        }
        List<double[]> beliefs = new ArrayList<>();
        List<double[]> kept = new ArrayList<>();
        for (int g = 0; g < count; g++) {
            if (Simplex.normalise(means[g], n) > 0) {
                beliefs.add(means[g]);
                kept.add(rows[g]);
            }
        }
        return new JointBelief<Self, Other>(beliefs, kept, limit).normalised();
    }

    private JointBelief<Self, Other> normalised() {
        double z = total(weights);
        List<double[]> rows = weights.stream().map(row -> Arrays.stream(row).map(x -> x / z).toArray()).toList();
        return new JointBelief<>(points, rows, limit);
    }

    private static double total(List<double[]> rows) {
        return rows.stream().mapToDouble(row -> Simplex.sum(row, row.length)).sum();
    }
}
