package handover.math;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** MODEL 6: the match scores, their ranges, and which of them are proper. */
class MatchScoreTest {
    private static final double ROUNDING = 1e-12;

    private static double lowest(MatchScore score, int n) {
        return switch (score) {
            case BRIER, L1, L2 -> -2;
            case LOG, KL -> Math.log(1e-3 / n);
            case LINEAR, NONE -> 0;
            case JS -> -Math.log(2);
        };
    }

    @Property(tries = 500, seed = "11")
    void valuesAreInTheirRange(@ForAll MatchScore score, @ForAll @IntRange(min = 1, max = 8) int n, @ForAll Random random) {
        double[] b = simplex(n, random);
        double[] h = simplex(n, random);
        double s = score.of(b, h, n);
        assertTrue(s >= lowest(score, n) - ROUNDING && s <= score.max(b, n) + ROUNDING,
                () -> score + " = " + s + ", expected " + lowest(score, n) + ".." + score.max(b, n));
    }

    @Property(tries = 500, seed = "12")
    void properScoresAreBestWhenHIsB(@ForAll @IntRange(min = 2, max = 8) int n, @ForAll Random random) {
        double[] b = simplex(n, random);
        double[] h = simplex(n, random);
        for (MatchScore score : Set.of(MatchScore.BRIER, MatchScore.KL, MatchScore.L1, MatchScore.L2, MatchScore.JS)) {
            // KL has b itself as its best h only up to the smoothing of 1e-3.
            double slack = score == MatchScore.KL ? 2e-3 : ROUNDING;
            assertTrue(score.of(b, b, n) >= score.of(b, h, n) - slack, () -> score + " prefers another h");
        }
        // The best h of the smoothed log score has h_eps = b, which exists if every b is at least 1e-3 / n.
        double[] inside = new double[n];
        double[] best = new double[n];
        for (int i = 0; i < n; i++) {
            inside[i] = 0.99 * b[i] + 0.01 / n;
            best[i] = (inside[i] - 1e-3 / n) / (1 - 1e-3);
        }
        assertTrue(MatchScore.LOG.of(inside, best, n) >= MatchScore.LOG.of(inside, h, n) - ROUNDING, "log is not proper");
        assertTrue(MatchScore.LOG.of(b, b, n) >= MatchScore.LOG.of(b, h, n) - 2e-3, "log prefers another h");
    }

    @Property(tries = 300, seed = "13")
    void brierIsStrictlyProperAndAnExpectation(@ForAll @IntRange(min = 2, max = 8) int n, @ForAll Random random) {
        double[] b = simplex(n, random);
        double[] h = simplex(n, random);
        double squares = 0;
        double expectation = 0;
        for (int i = 0; i < n; i++) {
            squares += (b[i] - h[i]) * (b[i] - h[i]);
            double loss = 0;
            for (int k = 0; k < n; k++) {
                loss += Math.pow((k == i ? 1 : 0) - h[k], 2);
            }
            expectation -= b[i] * loss;
        }
        assertEquals(squares, MatchScore.BRIER.of(b, b, n) - MatchScore.BRIER.of(b, h, n), ROUNDING,
                "what another h loses is its squared distance");
        assertEquals(expectation, MatchScore.BRIER.of(b, h, n), ROUNDING, "expectation of -||e - h||^2");
    }

    @Property(tries = 300, seed = "14")
    void theBestHOfLinearIsAVertex(@ForAll @IntRange(min = 1, max = 8) int n, @ForAll Random random) {
        double[] b = simplex(n, random);
        double best = MatchScore.LINEAR.of(b, Simplex.vertex(n, Simplex.argmax(b, n)), n);
        assertTrue(best >= MatchScore.LINEAR.of(b, simplex(n, random), n) - ROUNDING, "beaten by a mixture");
        assertTrue(best >= MatchScore.LINEAR.of(b, b, n) - ROUNDING, "beaten by b");
    }

    @Property(tries = 300, seed = "15")
    void exactlyTheBeliefDependentScoresAreNotLinearInB(@ForAll @IntRange(min = 2, max = 6) int n, @ForAll Random random) {
        double[] h = simplex(n, random);
        double[] b = simplex(n, random);
        for (MatchScore score : MatchScore.values()) {
            double mean = 0;
            for (int i = 0; i < n; i++) {
                mean += b[i] * score.of(Simplex.vertex(n, i), h, n);
            }
            double gap = score.of(b, h, n) - mean;
            assertTrue(score.beliefDependent() ? gap >= -ROUNDING : Math.abs(gap) < 1e-9,
                    () -> score + " is " + gap + " above its expectation over vertices");
        }
        assertEquals(EnumSet.of(MatchScore.KL, MatchScore.L1, MatchScore.L2, MatchScore.JS), EnumSet.copyOf(
                java.util.stream.Stream.of(MatchScore.values()).filter(MatchScore::beliefDependent).toList()));
    }

    @Test
    void byHand() {
        double[] b = {0.5, 0.5};
        double[] h = {0.9, 0.1};
        assertArrayEquals(new double[] {-0.82, 0.5, -0.8, -0.32, 0}, new double[] {MatchScore.BRIER.of(b, h, 2),
            MatchScore.LINEAR.of(b, h, 2), MatchScore.L1.of(b, h, 2), MatchScore.L2.of(b, h, 2),
            MatchScore.NONE.of(b, h, 2)}, ROUNDING);
        double log = (Math.log(0.8996) + Math.log(0.1004)) / 2;
        assertEquals(log, MatchScore.LOG.of(b, h, 2), ROUNDING, "log");
        assertEquals(log + Math.log(2), MatchScore.KL.of(b, h, 2), ROUNDING, "-KL = log score + entropy");
        double js = 0.25 * Math.log(0.5 / 0.7) + 0.25 * Math.log(0.5 / 0.3) + 0.45 * Math.log(0.9 / 0.7)
                + 0.05 * Math.log(0.1 / 0.3);
        assertEquals(-js, MatchScore.JS.of(b, h, 2), ROUNDING, "js");
    }

    @ParameterizedTest
    @EnumSource(MatchScore.class)
    void theSmallestProbabilitiesAreNoTrap(MatchScore score) {
        double[][] edges = {{1, 0}, {0, 1}, {1, Double.MIN_VALUE}, {Double.MIN_VALUE, 1}, {1 - 1e-16, 1e-16}};
        for (double[] b : edges) {
            for (double[] h : edges) {
                double s = score.of(b, h, 2);
                assertTrue(s >= lowest(score, 2) - ROUNDING && s <= score.max(b, 2) + ROUNDING,
                        () -> score + " = " + s + " for b = " + b[0] + ", " + b[1] + " and h = " + h[0] + ", " + h[1]);
            }
        }
    }

    private static double[] simplex(int n, Random random) {
        double[] p = new double[n];
        for (int i = 0; i < n; i++) {
            p[i] = random.nextInt(4) == 0 && i > 0 ? 0 : -Math.log(1 - random.nextDouble());
        }
        Simplex.normalise(p, n);
        return p;
    }
}
