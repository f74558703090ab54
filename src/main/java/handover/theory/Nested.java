package handover.theory;

import handover.math.MatchScore;
import org.ejml.data.DMatrixRMaj;

/**
 * Dirichlet level: the belief B of {@code S} about what the other believes about the choice of {@code S}, a distribution
 * over beta. {@code Nested<Robot>} is the robot's. Representations of the same thing: exact {@link Atoms}, boundedly many
 * {@link Clusters}, sampled {@link Particles}, one {@link DirichletBelief}, and {@link Adaptive}, which begins exact and
 * changes to a Dirichlet. All but {@link Particles} are immutable and thread safe.
 *
 * @param <S> who holds B, and whose choice beta is about
 */
public sealed interface Nested<S extends Agent<?, ?>> permits Atoms, Clusters, Particles, DirichletBelief,
        Adaptive {
    /** How many objects. */
    int size();

    /** E[beta], n entries that sum to one; the array must not be modified. */
    double[] mean();

    /** q = E ||beta||^2 = sum_j E[beta_j^2], in [1/n, 1]. */
    double meanSquare();

    /** S = E[beta beta^T], n x n, whose entries sum to one. */
    DMatrixRMaj secondMoments();

    /** B(T^T beta): the choice of {@code S} may have moved, and the other knows that. */
    Nested<S> predicted(Transition<S> t);

    /** sum_a~ P(a~ | a) B(U(beta, a~)): the other has perceived, or misperceived, an act of {@code S}. */
    Nested<S> perceived(Perception<S> act);

    /** B(beta) p(e | beta) / Z: the other did something that depends on its belief; unchanged if Z = 0. */
    Nested<S> given(Evidence<S> evidence);

    /**
     * E_B[S(b, beta)], the match reward under uncertainty about beta (MODEL 6). BRIER, LINEAR, L2 and L1 in closed form;
     * the others, for a Dirichlet, by quadrature over its Beta marginals, within 1e-9.
     *
     * @param b the robot's belief, n entries; not modified
     */
    double expected(MatchScore score, double[] b);

    /** One half-step of the other's clock, MODEL 3.2 with a perception in place of the act: predict, then correct. */
    default Nested<S> updated(Transition<S> t, Perception<S> act) {
        return predicted(t).perceived(act);
    }

    /** Total variance, sum_j Var[beta_j] = q - ||mean||^2, in [0, 1 - 1/n]. */
    default double variance() {
        double v = meanSquare();
        for (double m : mean()) {
            v -= m * m;
        }
        return Math.max(0, v);
    }
}
