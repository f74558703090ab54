package handover.theory;

import java.util.Arrays;

/**
 * Item level: where the own choice of {@code S} stands after what the other has done, p(i_t | a_{other,1:t}). Immutable,
 * thread safe; the array must not be modified.
 *
 * @param probabilities one entry per object, summing to one; copied
 * @param <S> whose own choice it is
 */
public record Choice<S extends Agent<?, ?>>(double[] probabilities) {
    /** Throws {@link IllegalArgumentException} if it is no distribution. */
    public Choice {
        probabilities = Weights.distribution("choice", probabilities);
    }

    /**
     * p(i_t | a_{1:t}) = sum_j p(i_t | j, a_t) p(j | a_{1:t-1}).
     *
     * @param kernel p(i | j, a_t), for instance {@link Transition#compliance}
     */
    public Choice<S> moved(Transition<S> kernel) {
        Weights.sameSize("kernel", probabilities.length, kernel.size());
        return new Choice<>(kernel.moved(probabilities));
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Choice<?> c && Arrays.equals(probabilities, c.probabilities);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(probabilities);
    }

    @Override
    public String toString() {
        return "Choice" + Arrays.toString(probabilities);
    }
}
