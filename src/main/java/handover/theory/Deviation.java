package handover.theory;

import handover.math.MatchScore;
import handover.math.Simplex;

/**
 * How far one representation of B is from another.
 *
 * @param l1 ||E[beta] - E_ref[beta]||_1, in [0, 2]
 * @param variance total variance minus that of the reference (negative: too sure)
 * @param relativeEntropy KL(E_ref[beta] || E[beta]), nats
 * @param score expected Brier match score minus that of the reference, for a robot that is sure of its choice
 */
public record Deviation(double l1, double variance, double relativeEntropy, double score) {
    /** Of {@code b} from {@code reference}, for a robot that has chosen {@code chosen}. */
    public static Deviation between(Nested<?> b, Nested<?> reference, int chosen) {
        double[] mean = b.mean();
        double[] right = reference.mean();
        double kl = 0;
        for (int i = 0; i < mean.length; i++) {
            kl += right[i] > 0 ? right[i] * Math.log(right[i] / mean[i]) : 0;
        }
        double[] certain = Simplex.vertex(mean.length, chosen);
        return new Deviation(Simplex.l1(mean, right), b.variance() - reference.variance(), Math.max(0, kl),
                b.expected(MatchScore.BRIER, certain) - reference.expected(MatchScore.BRIER, certain));
    }
}
