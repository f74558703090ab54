package handover.theory;

import handover.math.Simplex;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Categorical level: what the other believes about the choice of {@code S}. {@code Categorical<Robot>} is the human's beta,
 * {@code Categorical<Human>} is the robot's b. Immutable, thread safe; the array must not be modified.
 *
 * @param probabilities one entry per object, summing to one; copied
 * @param <S> whose choice it is about
 */
public record Categorical<S extends Agent<?, ?>>(double[] probabilities) {
    /** Throws {@link IllegalArgumentException} if it is no distribution. */
    public Categorical {
        probabilities = Weights.distribution("belief", probabilities);
    }

    public static <S extends Agent<?, ?>> Categorical<S> uniform(int n) {
        return new Categorical<>(Simplex.uniform(n));
    }

    public int size() {
        return probabilities.length;
    }

    /** T^T p: the choice moves, nothing is perceived. */
    public Categorical<S> predicted(Transition<S> t) {
        Weights.sameSize("transition", size(), t.size());
        return new Categorical<>(t.moved(probabilities));
    }

    /** D(lambda) p / 1^T D(lambda) p; unchanged if every object that is possible has likelihood zero (MODEL 4.3). */
    public Categorical<S> given(Message<S> message) {
        Weights.sameSize("likelihood", size(), message.size());
        return new Categorical<>(corrected(probabilities, message.likelihood()));
    }

    /** The whole update U(p, a) = D(lambda) T^T p / 1^T D(lambda) T^T p (MODEL 3.2); only propagated if that is 0/0. */
    public Categorical<S> updated(Transition<S> t, Message<S> message) {
        Weights.sameSize("transition", size(), t.size());
        DMatrixRMaj next = new DMatrixRMaj(size(), 1);
        CommonOps_DDRM.mult(updateMatrix(t, message), DMatrixRMaj.wrap(size(), 1, probabilities), next);
        double z = CommonOps_DDRM.elementSum(next);
        if (!(z > 0)) {
            return predicted(t);
        }
        CommonOps_DDRM.divide(next, z);
        return new Categorical<>(next.data);
    }

    /** D(lambda) T^T, n x n, with lambda scaled to a largest entry of 1 (a factor that the normaliser cancels). */
    public static <S extends Agent<?, ?>> DMatrixRMaj updateMatrix(Transition<S> t, Message<S> message) {
        Weights.sameSize("likelihood", t.size(), message.size());
        DMatrixRMaj product = new DMatrixRMaj(t.size(), t.size());
        CommonOps_DDRM.multTransB(CommonOps_DDRM.diag(scaled(message.likelihood())), t.matrix(), product);
        return product;
    }

    /** Bayes' rule on raw arrays, not modified: a new array, a copy of {@code p} if sum p l = 0. */
    static double[] corrected(double[] p, double[] likelihood) {
        double max = 0;
        for (double l : likelihood) {
            max = Math.max(max, l);
        }
        double[] out = new double[p.length];
        for (int i = 0; i < p.length && max > 0; i++) {
            out[i] = likelihood[i] / max * p[i];
        }
        return Simplex.normalise(out, out.length) > 0 ? out : p.clone();
    }

    /** {@code l} divided by its largest entry; zeros if that is zero. */
    static double[] scaled(double[] l) {
        double max = 0;
        for (double x : l) {
            max = Math.max(max, x);
        }
        double[] out = new double[l.length];
        for (int i = 0; i < l.length && max > 0; i++) {
            out[i] = l[i] / max;
        }
        return out;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Categorical<?> c && Arrays.equals(probabilities, c.probabilities);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(probabilities);
    }

    @Override
    public String toString() {
        return "Categorical" + Arrays.toString(probabilities);
    }
}
