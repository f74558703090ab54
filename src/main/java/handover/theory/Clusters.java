package handover.theory;

import handover.math.MatchScore;
import org.ejml.data.DMatrixRMaj;

/**
 * B as at most {@code limit} weighted beliefs, without chance: exact until more are possible, then near ones (in the
 * Hellinger distance) are replaced by their weighted mean. A merge leaves E[beta] as it is and loses the variance within
 * the cluster. Where B has several peaks (an act was seen or it was missed), which no Dirichlet has, this is the
 * representation for a robot; docs/theory.md has the numbers. Immutable, thread safe.
 *
 * @param atoms the beliefs
 * @param limit how many are kept, at least 1
 * @param <S> who holds B
 */
public record Clusters<S extends Agent<?, ?>>(Atoms<S> atoms, int limit) implements Nested<S> {
    /** Throws {@link IllegalArgumentException} if the limit is not positive. */
    public Clusters {
        if (limit < 1) {
            throw new IllegalArgumentException("limit: expected at least 1 cluster, got " + limit);
        }
        atoms = atoms.count() > limit ? Clustering.reduced(atoms, limit) : atoms;
    }

    /** From a known belief of the other. */
    public static <S extends Agent<?, ?>> Clusters<S> certain(Categorical<S> beta, int limit) {
        return new Clusters<>(Atoms.certain(beta), limit);
    }

    @Override
    public int size() {
        return atoms.size();
    }

    @Override
    public double[] mean() {
        return atoms.mean();
    }

    @Override
    public double meanSquare() {
        return atoms.meanSquare();
    }

    @Override
    public DMatrixRMaj secondMoments() {
        return atoms.secondMoments();
    }

    @Override
    public Clusters<S> predicted(Transition<S> t) {
        return new Clusters<>(atoms.predicted(t), limit);
    }

    @Override
    public Clusters<S> perceived(Perception<S> act) {
        return new Clusters<>(atoms.perceived(act), limit);
    }

    @Override
    public Clusters<S> given(Evidence<S> evidence) {
        return new Clusters<>(atoms.given(evidence), limit);
    }

    @Override
    public double expected(MatchScore score, double[] b) {
        return atoms.expected(score, b);
    }
}
