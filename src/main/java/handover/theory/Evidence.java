package handover.theory;

import java.util.Arrays;

/**
 * What the other does because of its belief beta about the choice of {@code S}, linear in beta:
 * p(e | beta) = sum_j w_j beta_j, for instance "you will give me the cup" or speaking up because the wanted object is not
 * expected, phi + kappa (1 - beta_omega). Immutable, thread safe; the array must not be modified.
 *
 * @param weights p(e | the other is certain of j), finite and not negative; copied
 * @param <S> whose choice beta is about
 */
public record Evidence<S extends Agent<?, ?>>(double[] weights) {
    /** Throws {@link IllegalArgumentException} if an entry is negative or not finite. */
    public Evidence {
        weights = Weights.checked("weights", weights);
    }

    /** p(e | beta) = w . beta; {@code beta} is not modified. */
    public double given(double[] beta) {
        Weights.sameSize("evidence", weights.length, beta.length);
        double s = 0;
        for (int j = 0; j < beta.length; j++) {
            s += weights[j] * beta[j];
        }
        return s;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Evidence<?> e && Arrays.equals(weights, e.weights);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(weights);
    }

    @Override
    public String toString() {
        return "Evidence" + Arrays.toString(weights);
    }
}
