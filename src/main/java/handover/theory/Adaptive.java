package handover.theory;

import handover.math.MatchScore;
import org.ejml.data.DMatrixRMaj;

/**
 * Exact as long as that is affordable: atoms, projected to one Dirichlet when they become more than {@code limit}, which
 * it then stays. Immutable, thread safe.
 *
 * @param now atoms or a Dirichlet
 * @param limit how many atoms are affordable, at least 1
 * @param projection to which Dirichlet
 * @param <S> who holds B
 */
public record Adaptive<S extends Agent<?, ?>>(Nested<S> now, int limit, Projection projection) implements Nested<S> {
    /** Throws {@link IllegalArgumentException} if {@code now} is neither, or the limit is not positive. */
    public Adaptive {
        if (!(now instanceof Atoms<S> || now instanceof DirichletBelief<S>) || limit < 1) {
            throw new IllegalArgumentException("expected atoms or a Dirichlet and a limit >= 1, got " + now + ", " + limit);
        }
    }

    /** From a known belief of the other. */
    public static <S extends Agent<?, ?>> Adaptive<S> certain(Categorical<S> beta, int limit, Projection projection) {
        return new Adaptive<>(Atoms.certain(beta), limit, projection);
    }

    /** Whether nothing was approximated so far. */
    public boolean exact() {
        return now instanceof Atoms<S>;
    }

    private Adaptive<S> then(Nested<S> next) {
        boolean tooMany = next instanceof Atoms<S> atoms && atoms.count() > limit;
        return new Adaptive<>(tooMany ? DirichletBelief.project((Atoms<S>) next, projection) : next, limit, projection);
    }

    @Override
    public int size() {
        return now.size();
    }

    @Override
    public double[] mean() {
        return now.mean();
    }

    @Override
    public double meanSquare() {
        return now.meanSquare();
    }

    @Override
    public DMatrixRMaj secondMoments() {
        return now.secondMoments();
    }

    @Override
    public Adaptive<S> predicted(Transition<S> t) {
        return then(now.predicted(t));
    }

    @Override
    public Adaptive<S> perceived(Perception<S> act) {
        return then(now.perceived(act));
    }

    @Override
    public Adaptive<S> given(Evidence<S> evidence) {
        return then(now.given(evidence));
    }

    @Override
    public double expected(MatchScore score, double[] b) {
        return now.expected(score, b);
    }
}
