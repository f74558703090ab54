package handover.theory;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * How the choice of {@code S} moves in one step: the matrix T with T(j, i) = p(next = i | now = j), rows summing to one, so
 * that a distribution p moves to T^T p. Immutable, thread safe; the matrix must not be modified.
 *
 * @param matrix T, n x n
 * @param <S> whose choice moves
 */
public record Transition<S extends Agent<?, ?>>(DMatrixRMaj matrix) {
    /** Throws {@link IllegalArgumentException} if the matrix is not square or a row is no distribution. */
    public Transition {
        Weights.sameSize("transition", matrix.numRows, matrix.numCols);
        for (int j = 0; j < matrix.numRows; j++) {
            double[] row = new double[matrix.numCols];
            System.arraycopy(matrix.data, j * row.length, row, 0, row.length);
            Weights.distribution("transition[" + j + "]", row);
        }
        matrix = matrix.copy();
    }

    /**
     * T_stay over {@code n} objects (MODEL 1): stays with probability {@code stay}, else moves to another one uniformly.
     */
    public static <S extends Agent<?, ?>> Transition<S> stay(int n, double stay) {
        double move = n == 1 ? 0 : (1 - Weights.probability("stay", stay)) / (n - 1);
        DMatrixRMaj t = new DMatrixRMaj(n, n);
        CommonOps_DDRM.fill(t, move);
        for (int i = 0; i < n; i++) {
            t.set(i, i, n == 1 ? 1 : stay);
        }
        return new Transition<>(t);
    }

    /**
     * The compliance kernel of the item level (MODEL 8): on hearing the other's act, {@code S} keeps its choice with
     * probability 1 - c, else takes the one that the act asks for,
     * p(i | j, a) = (1-c) [i = j] + c lambda(a|i) / sum_k lambda(a|k). An act that is impossible for every object changes
     * nothing.
     *
     * @param c compliance, in [0, 1]
     * @param heard the other's act
     */
    public static <S extends Agent<S, O>, O extends Agent<O, S>> Transition<S> compliance(double c, Message<O> heard) {
        Weights.probability("compliance", c);
        double[] target = heard.normalised();
        int n = heard.size();
        boolean impossible = heard.uninformative() && heard.likelihood()[0] == 0;
        DMatrixRMaj t = CommonOps_DDRM.identity(n);
        for (int j = 0; j < n && !impossible; j++) {
            for (int i = 0; i < n; i++) {
                t.set(j, i, (i == j ? 1 - c : 0) + c * target[i]);
            }
        }
        return new Transition<>(t);
    }

    /** First this, then {@code next}: the product of the two. */
    public Transition<S> then(Transition<S> next) {
        DMatrixRMaj product = new DMatrixRMaj(size(), size());
        CommonOps_DDRM.mult(matrix, next.matrix, product);
        return new Transition<>(product);
    }

    public int size() {
        return matrix.numRows;
    }

    /** T^T p, as a new array; {@code p} (n entries) is not modified. */
    public double[] moved(double[] p) {
        double[] out = new double[p.length];
        CommonOps_DDRM.multTransA(matrix, DMatrixRMaj.wrap(p.length, 1, p), DMatrixRMaj.wrap(p.length, 1, out));
        return out;
    }

    /** T^T S T, the second moments of T^T beta when those of beta are {@code s} (n x n, not modified). */
    public DMatrixRMaj moved(DMatrixRMaj s) {
        DMatrixRMaj half = new DMatrixRMaj(size(), size());
        DMatrixRMaj whole = new DMatrixRMaj(size(), size());
        CommonOps_DDRM.multTransA(matrix, s, half);
        CommonOps_DDRM.mult(half, matrix, whole);
        return whole;
    }

    /** Whether nothing moves. */
    public boolean still() {
        for (int i = 0; i < size(); i++) {
            if (matrix.unsafe_get(i, i) != 1) {
                return false;
            }
        }
        return true;
    }
}
