package handover.theory;

import handover.math.MatchScore;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import org.ejml.data.DMatrixRMaj;

/**
 * B as at most {@code limit} weighted beliefs: the Rao-Blackwellised reference. Given what was perceived, beta is a known
 * function, so only the perceived acts are chance; of these the last one is summed out exactly (every particle goes on as
 * every act that it may have perceived), and chance enters only where more than {@code limit} beliefs are left: the heavy
 * ones stay as they are, the light ones are resampled without bias. Up to the limit it is exact.
 *
 * <p>Not thread safe: it draws from the generator that it was made with, as do all the beliefs that follow from it.
 *
 * <p>Source: Fearnhead and Clifford, "On-line inference for hidden Markov models via particle filters", 2003 (the
 * resampling); Doucet et al., "Rao-Blackwellised particle filtering for dynamic Bayesian networks", 2000.
 *
 * @param atoms the particles
 * @param limit how many are kept, at least 1
 * @param random where chance comes from
 * @param <S> who holds B
 */
public record Particles<S extends Agent<?, ?>>(Atoms<S> atoms, int limit, RandomGenerator random) implements Nested<S> {
    /** Throws {@link IllegalArgumentException} if the limit is not positive. */
    public Particles {
        if (limit < 1) {
            throw new IllegalArgumentException("limit: expected at least 1 particle, got " + limit);
        }
    }

    /** From a known belief of the other. */
    public static <S extends Agent<?, ?>> Particles<S> certain(Categorical<S> beta, int limit, RandomGenerator random) {
        return new Particles<>(Atoms.certain(beta), limit, random);
    }

    /** {@code limit} beliefs drawn from a Dirichlet. */
    public static <S extends Agent<?, ?>> Particles<S> of(DirichletBelief<S> prior, int limit, RandomGenerator random) {
        List<double[]> points = new ArrayList<>();
        for (int k = 0; k < limit; k++) {
            points.add(prior.sample(random));
        }
        double[] w = new double[limit];
        Arrays.fill(w, 1.0 / limit);
        return new Particles<>(new Atoms<>(w, points), limit, random);
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
    public Particles<S> predicted(Transition<S> t) {
        return new Particles<>(atoms.predicted(t), limit, random);
    }

    @Override
    public Particles<S> perceived(Perception<S> act) {
        Atoms<S> next = atoms.perceived(act);
        return new Particles<>(next.count() > limit ? Resampling.reduced(next, limit, random) : next, limit, random);
    }

    @Override
    public Particles<S> given(Evidence<S> evidence) {
        return new Particles<>(atoms.given(evidence), limit, random);
    }

    @Override
    public double expected(MatchScore score, double[] b) {
        return atoms.expected(score, b);
    }
}
