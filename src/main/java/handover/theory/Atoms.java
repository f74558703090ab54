package handover.theory;

import handover.math.MatchScore;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * B as finitely many beliefs with weights. Exact from a known start: every act multiplies the atoms by the number of acts
 * that may have been perceived, and equal ones (each entry within {@link #TOLERANCE}, relatively) are merged. If nothing
 * moves (T = 1), the order in which acts were perceived does not matter, and the number of atoms stays polynomial in the
 * number of acts. Immutable, thread safe; arrays must not be modified.
 *
 * @param weights one per atom, summing to one; copied
 * @param points one belief per atom, each over n objects and summing to one
 * @param <S> who holds B
 */
public record Atoms<S extends Agent<?, ?>>(double[] weights, List<double[]> points) implements Nested<S> {
    /**
     * Beliefs all of whose entries agree to this relative precision are the same atom. Relative, because a belief next to
     * a vertex must keep what it holds possible: with T = 1 later acts can bring it back.
     */
    public static final double TOLERANCE = 1e-12;

    /** Throws {@link IllegalArgumentException} if the weights are no distribution or sizes differ. */
    public Atoms {
        weights = Weights.distribution("atom weights", weights);
        points = List.copyOf(points);
        Weights.sameSize("atoms", weights.length, points.size());
    }

    /** Certainty that the other's belief is {@code beta}. */
    public static <S extends Agent<?, ?>> Atoms<S> certain(Categorical<S> beta) {
        return new Atoms<>(new double[] {1}, List.of(beta.probabilities()));
    }

    /** How many beliefs are possible. */
    public int count() {
        return weights.length;
    }

    @Override
    public int size() {
        return points.get(0).length;
    }

    @Override
    public double[] mean() {
        double[] m = new double[size()];
        for (int k = 0; k < weights.length; k++) {
            for (int i = 0; i < m.length; i++) {
                m[i] += weights[k] * points.get(k)[i];
            }
        }
        return m;
    }

    @Override
    public double meanSquare() {
        double q = 0;
        for (int k = 0; k < weights.length; k++) {
            for (double x : points.get(k)) {
                q += weights[k] * x * x;
            }
        }
        return q;
    }

    @Override
    public DMatrixRMaj secondMoments() {
        DMatrixRMaj s = new DMatrixRMaj(size(), size());
        for (int k = 0; k < weights.length; k++) {
            DMatrixRMaj column = DMatrixRMaj.wrap(size(), 1, points.get(k));
            CommonOps_DDRM.multAddTransB(weights[k], column, column, s);
        }
        return s;
    }

    /** E log beta_j, one entry per object; -infinity where an atom excludes the object. */
    public double[] meanLog() {
        double[] g = new double[size()];
        for (int k = 0; k < weights.length; k++) {
            for (int i = 0; i < g.length && weights[k] > 0; i++) {
                g[i] += weights[k] * Math.log(points.get(k)[i]);
            }
        }
        return g;
    }

    @Override
    public Atoms<S> predicted(Transition<S> t) {
        Weights.sameSize("transition", size(), t.size());
        return t.still() ? this : new Atoms<S>(weights, points.stream().map(t::moved).toList());
    }

    @Override
    public Atoms<S> perceived(Perception<S> act) {
        Weights.sameSize("perceived act", size(), act.objects());
        List<double[]> next = new ArrayList<>(count() * act.size());
        double[] w = new double[count() * act.size()];
        for (int a = 0; a < act.size(); a++) {
            double[] likelihood = act.messages().get(a).likelihood();
            for (int k = 0; k < weights.length; k++) {
                w[next.size()] = weights[k] * act.probabilities()[a];
                next.add(Categorical.corrected(points.get(k), likelihood));
            }
        }
        return Merging.merged(w, next);
    }

    @Override
    public Atoms<S> given(Evidence<S> evidence) {
        double[] likelihood = new double[count()];
        for (int k = 0; k < weights.length; k++) {
            likelihood[k] = evidence.given(points.get(k));
        }
        return new Atoms<>(Categorical.corrected(weights, likelihood), points);
    }

    /** p(e) = sum_k w_k p(e | beta_k). */
    public double probability(Evidence<S> evidence) {
        return evidence.given(mean());
    }

    @Override
    public double expected(MatchScore score, double[] b) {
        double s = 0;
        for (int k = 0; k < weights.length; k++) {
            s += weights[k] * score.of(b, points.get(k), b.length);
        }
        return s;
    }

    @Override
    public String toString() {
        return "Atoms[" + count() + "]";
    }
}
