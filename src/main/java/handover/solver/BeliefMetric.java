package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.InvalidParameterException;

/**
 * How far two beliefs with the same discrete part are from each other:
 * d = sqrt(H(b, b')^2 + w H(h, h')^2) with the Hellinger distance H(p, q)^2 = 1/2 sum_i (sqrt p_i - sqrt q_i)^2, so that d is
 * in [0, sqrt(1 + w)]. It is Euclidean in sqrt(b), sqrt(h), which is what is stored, as 32-bit floats. Near certainty, where a
 * wrong pick is decided, it tells probabilities apart that L1 hardly does: 0.99 and 0.95 are as far from each other as 0.7 and
 * 0.58. Immutable.
 *
 * @param humanWeight w, what h counts against b; at least 0
 */
public record BeliefMetric(double humanWeight) {
    /** What files call it. */
    public static final String NAME = "hellinger";
    /** b decides what can be handed over, h only what is paid for being understood. */
    public static final BeliefMetric DEFAULT = new BeliefMetric(0.25);

    /** Throws {@link InvalidParameterException} for a weight below 0. */
    public BeliefMetric {
        if (!(humanWeight >= 0 && humanWeight <= 1e6)) {
            throw new InvalidParameterException("human_weight", humanWeight, "a weight from 0 to 1e6");
        }
    }

    /**
     * The coordinates of a belief.
     *
     * @param to object i becomes object {@code to[i]}; not modified
     * @param out of length 2n; modified
     */
    void coordinates(HandoverBelief belief, int[] to, float[] out) {
        double[] b = belief.probabilities();
        double[] h = belief.human();
        int n = b.length;
        for (int i = 0; i < n; i++) {
            out[to[i]] = (float) Math.sqrt(b[i] / 2);
            out[n + to[i]] = (float) Math.sqrt(humanWeight * h[i] / 2);
        }
    }

    /**
     * The squared distance of two rows of {@code dimensions} coordinates, an even number; once above {@code limit}, any number
     * above it. Summed in two chains, which a processor follows at the same time.
     */
    static float squared(float[] a, int from, float[] b, int start, int dimensions, float limit) {
        float even = 0;
        float odd = 0;
        for (int k = 0; k < dimensions; k += 2) {
            float s = a[from + k] - b[start + k];
            float t = a[from + k + 1] - b[start + k + 1];
            even += s * s;
            odd += t * t;
            if ((k & 2) != 0 && even + odd > limit) {
                return even + odd;
            }
        }
        return even + odd;
    }
}
