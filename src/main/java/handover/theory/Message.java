package handover.theory;

import handover.math.Simplex;
import java.util.Arrays;

/**
 * What an act of {@code S} says about the choice of {@code S}: lambda(a | i), one entry per object (MODEL 3.1). Only ratios
 * matter. Immutable, thread safe; the array must not be modified.
 *
 * @param likelihood p(act | choice = i), finite and not negative; copied
 * @param <S> who acts
 */
public record Message<S extends Agent<?, ?>>(double[] likelihood) {
    /** Throws {@link IllegalArgumentException} if an entry is negative or not finite. */
    public Message {
        likelihood = Weights.checked("likelihood", likelihood);
    }

    /** An act that says nothing, or one that was missed: the same likelihood for each of {@code n} objects. */
    public static <S extends Agent<?, ?>> Message<S> nothing(int n) {
        double[] ones = new double[n];
        Arrays.fill(ones, 1);
        return new Message<>(ones);
    }

    public int size() {
        return likelihood.length;
    }

    /**
     * Whether every object is equally likely, so that a belief is only propagated; so it is if none is possible (MODEL
     * 4.3).
     */
    public boolean uninformative() {
        for (double l : likelihood) {
            if (l != likelihood[0]) {
                return false;
            }
        }
        return true;
    }

    /** lambda(a|i) / sum_k lambda(a|k); uniform if every entry is zero. */
    public double[] normalised() {
        double[] p = likelihood.clone();
        return Simplex.normalise(p, p.length) > 0 ? p : Simplex.uniform(p.length);
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Message<?> m && Arrays.equals(likelihood, m.likelihood);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(likelihood);
    }

    @Override
    public String toString() {
        return "Message" + Arrays.toString(likelihood);
    }
}
