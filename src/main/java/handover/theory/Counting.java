package handover.theory;

import handover.math.Simplex;

/**
 * The rule that suggests itself and is wrong: add to alpha what was said, alpha_j += sum_a~ P(a~ | a) lambda(a~ | j) /
 * sum_k lambda(a~ | k). It treats an act as a draw from beta, while it is evidence that <em>moves</em> beta; kept for
 * comparison.
 */
public final class Counting {
    private Counting() {}

    /** {@code before} with the counts of an act added; an act that says nothing adds nothing. */
    public static <S extends Agent<?, ?>> DirichletBelief<S> counted(DirichletBelief<S> before, Perception<S> act) {
        double[] alpha = before.alpha();
        for (int a = 0; a < act.size(); a++) {
            Message<S> message = act.messages().get(a);
            double[] share = message.normalised();
            for (int j = 0; j < alpha.length && !message.uninformative(); j++) {
                alpha[j] += act.probabilities()[a] * share[j];
            }
        }
        return DirichletBelief.of(alpha, before.projection());
    }

    /** Where counting starts: Dir(1, ..., 1), whose mean is uniform. */
    public static <S extends Agent<?, ?>> DirichletBelief<S> start(int n) {
        return new DirichletBelief<>(Simplex.uniform(n), n, Projection.MOMENTS);
    }
}
