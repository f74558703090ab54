package handover.theory;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.math.MatchScore;
import handover.math.Simplex;
import handover.theory.Agent.Robot;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** E_B of the match scores. */
class ExpectedScoreTest {
    private static final double[] B = {0.1, 0.6, 0.3};

    private static DirichletBelief<Robot> dirichlet(double... alpha) {
        return DirichletBelief.of(alpha, Projection.MOMENTS);
    }

    /** Every score, every shape of Dirichlet, against 300,000 draws: 4 standard errors, 32 comparisons, odds 0.2%. */
    @ParameterizedTest
    @EnumSource(MatchScore.class)
    void agreesWithDraws(MatchScore score) {
        for (double[] alpha : new double[][] {{1, 2, 3}, {0.05, 0.2, 0.1}, {50, 400, 3}, {0.05, 500, 1}}) {
            DirichletBelief<Robot> b = dirichlet(alpha);
            SplittableRandom random = new SplittableRandom(9);
            double sum = 0;
            double squares = 0;
            int draws = 300_000;
            for (int d = 0; d < draws; d++) {
                double s = score.of(B, b.sample(random), 3);
                sum += s;
                squares += s * s;
            }
            double mean = sum / draws;
            double error = Math.sqrt(Math.max(0, squares / draws - mean * mean) / draws);
            assertEquals(mean, b.expected(score, B), 4 * error + 1e-12, score + " " + b);
        }
    }

    /** E ||e_i - beta||^2 = 1 - 2 m_i + q, by the moments of a Dirichlet written out. */
    @Test
    void brierByHand() {
        double q = (1 * 2 + 2 * 3 + 3 * 4) / (6.0 * 7);
        assertEquals(-(1 - 2 * 2 / 6.0 + q), dirichlet(1, 2, 3).expected(MatchScore.BRIER, Simplex.vertex(3, 1)), 1e-14);
    }

    /** Dir(1,1): E log beta_j = int_0^1 log x dx = -1. */
    @Test
    void logByHand() {
        assertEquals(-1, dirichlet(1, 1).expectedLog(new double[] {0.3, 0.7}), 1e-13);
        assertEquals(Digamma.of(2) - Digamma.of(6), dirichlet(1, 2, 3).expectedLog(Simplex.vertex(3, 1)), 1e-13);
        assertEquals(Double.NEGATIVE_INFINITY, dirichlet(0, 1, 1).expectedLog(B));
    }

    /** Dir(1,1), smoothed: int_0^1 log(c + d x) dx has a primitive. */
    @Test
    void smoothedLogByHand() {
        double c = 1e-3 / 2;
        double d = 1 - 1e-3;
        DoubleUnaryOperator primitive = x -> (c + d * x) * (Math.log(c + d * x) - 1) / d;
        assertEquals(primitive.applyAsDouble(1) - primitive.applyAsDouble(0),
                dirichlet(1, 1).expected(MatchScore.LOG, new double[] {0.3, 0.7}), 1e-12);
    }

    /** Dir(1,1): E|x - c| = (c^2 + (1-c)^2) / 2. */
    @Test
    void absoluteDeviationByHand() {
        assertEquals(-(0.3 * 0.3 + 0.7 * 0.7), dirichlet(1, 1).expected(MatchScore.L1, new double[] {0.3, 0.7}), 1e-12);
        assertEquals(-(0.25 + 0.25), dirichlet(1, 3).expected(MatchScore.L1, Simplex.vertex(2, 1)), 1e-12);
        assertEquals(-1.5, dirichlet(1e7, 3e7).expected(MatchScore.L1, Simplex.vertex(2, 0)), 1e-6);
    }

    /** The limits are what they stand for: a known belief, and vertices. */
    @ParameterizedTest
    @EnumSource(MatchScore.class)
    void limits(MatchScore score) {
        double[] beta = {0.2, 0.3, 0.5};
        assertEquals(score.of(B, beta, 3), new DirichletBelief<Robot>(beta, Double.POSITIVE_INFINITY, Projection.MOMENTS)
                .expected(score, B), 1e-12);
        double vertices = 0;
        for (int j = 0; j < 3; j++) {
            vertices += beta[j] * score.of(B, Simplex.vertex(3, j), 3);
        }
        assertEquals(vertices, new DirichletBelief<Robot>(beta, 0, Projection.MOMENTS).expected(score, B), 1e-12);
        assertEquals(vertices, new DirichletBelief<Robot>(beta, 1e-9, Projection.MOMENTS).expected(score, B), 1e-6);
        for (double big : new double[] {1e11, 1e13, 1e300}) {
            assertEquals(score.of(B, beta, 3), new DirichletBelief<Robot>(beta, big, Projection.MOMENTS)
                    .expected(score, B), 1e-5);
        }
    }

    /** Atoms and their projection agree on every score that depends on the mean and E ||beta||^2 alone. */
    @Property(tries = 50)
    void theProjectionKeepsBrierScores(@ForAll @IntRange(min = 2, max = 10) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Atoms<Robot> atoms = Atoms.certain(RandomTheory.<Robot>belief(n, random))
                .perceived(RandomTheory.perception(n, random)).perceived(RandomTheory.perception(n, random));
        DirichletBelief<Robot> b = DirichletBelief.project(atoms, Projection.MOMENTS);
        double[] own = RandomDirichlets.belief(n, random);
        for (MatchScore score : new MatchScore[] {MatchScore.BRIER, MatchScore.L2, MatchScore.LINEAR}) {
            assertEquals(atoms.expected(score, own), b.expected(score, own), 1e-12);
        }
        DirichletBelief<Robot> logs = DirichletBelief.project(atoms, Projection.LOG_MOMENTS);
        double expected = 0;
        for (int j = 0; j < n; j++) {
            expected += own[j] * atoms.meanLog()[j];
        }
        assertEquals(expected, logs.expectedLog(own), 1e-8 * Math.abs(expected));
    }
}
