package handover.math;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Kernels on probability vectors. */
class SimplexTest {
    private static final double ROUNDING = 1e-14;

    @Property(tries = 300, seed = "16")
    void propagationIsTheMatrixProduct(@ForAll @IntRange(min = 1, max = 8) int n,
            @ForAll @DoubleRange(min = 0, max = 1) double stay, @ForAll Random random) {
        double[] p = random.doubles(n).toArray();
        Simplex.normalise(p, n);
        double[] expected = new double[n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                expected[i] += p[j] * (n == 1 ? 1 : i == j ? stay : (1 - stay) / (n - 1));
            }
        }
        double[] out = new double[n];
        Simplex.propagate(stay, p, out, n);
        assertArrayEquals(expected, out, ROUNDING);
        Simplex.propagate(stay, p, p, n);
        assertArrayEquals(expected, p, ROUNDING, "in place");
    }

    @Property(tries = 300, seed = "22")
    void anUpdateIsAPropagationAndBayesRule(@ForAll @IntRange(min = 1, max = 8) int n,
            @ForAll @DoubleRange(min = 0, max = 1) double stay, @ForAll Random random) {
        double[] p = random.doubles(n).toArray();
        Simplex.normalise(p, n);
        double[] likelihood = random.doubles(n).map(x -> x < 0.3 ? 0 : x).toArray();
        double[] expected = new double[n];
        Simplex.propagate(stay, p, expected, n);
        double[] out = new double[n];
        Simplex.update(stay, p, likelihood, out, n);
        double z = 0;
        for (int i = 0; i < n; i++) {
            z += likelihood[i] * expected[i];
        }
        for (int i = 0; i < n && z > 0; i++) {
            expected[i] *= likelihood[i] / z;
        }
        assertArrayEquals(expected, out, ROUNDING);
    }

    /** 1/z overflows for z below about 5.6e-309, which a narrow POINT gives to an object at 37 standard deviations. */
    @Test
    void anUpdateByTheSmallestLikelihoods() {
        for (double tiny : new double[] {1e-300, 1e-308, 1e-309, 1e-320}) {
            double[] out = new double[2];
            Simplex.update(1, new double[] {1, 0}, new double[] {tiny, 1}, out, 2);
            assertArrayEquals(new double[] {1, 0}, out, ROUNDING, "likelihood " + tiny);
        }
    }

    @Test
    void distributions() {
        assertArrayEquals(new double[] {0.25, 0.25, 0.25, 0.25}, Simplex.uniform(4), 0);
        assertArrayEquals(new double[0], Simplex.uniform(0), 0);
        assertArrayEquals(new double[] {0, 1, 0}, Simplex.vertex(3, 1), 0);
        assertEquals(0.75, Simplex.l1(new double[] {0.5, 0.5, 0}, new double[] {0.25, 0.375, 0.375}), ROUNDING);
        assertEquals(2, Simplex.l1(Simplex.vertex(2, 0), Simplex.vertex(2, 1)), 0);
    }

    @Test
    void normaliseLeavesWhatItCannotScale() {
        double[] p = {1, 3, 9};
        assertEquals(4, Simplex.normalise(p, 2), 0, "the sum of the first two");
        assertArrayEquals(new double[] {0.25, 0.75, 9}, p, 0);
        double[] zero = {0, 0};
        assertEquals(0, Simplex.normalise(zero, 2), 0);
        assertArrayEquals(new double[] {0, 0}, zero, 0);
        double[] infinite = {1, Double.POSITIVE_INFINITY};
        Simplex.normalise(infinite, 2);
        assertArrayEquals(new double[] {1, Double.POSITIVE_INFINITY}, infinite, 0);
    }

    @Property(tries = 300, seed = "17")
    void logWeightsNormaliseWithoutUnderflow(@ForAll @IntRange(min = 1, max = 8) int n,
            @ForAll @DoubleRange(min = -1e5, max = 1e5) double shift, @ForAll Random random) {
        double[] log = random.doubles(n, -20, 20).map(x -> x + shift).toArray();
        double[] found = log.clone();
        assertTrue(Simplex.normaliseLog(found));
        assertEquals(1, Arrays.stream(found).map(Math::exp).sum(), 1e-9, "sum");
        for (int i = 0; i < n; i++) {
            assertEquals(log[i] - log[0], found[i] - found[0], 1e-9, "log odds");
        }
        assertEquals(0, Simplex.logSumExp(found), 1e-9);
    }

    @Test
    void nothingButZeros() {
        double[] none = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        assertFalse(Simplex.normaliseLog(none));
        assertArrayEquals(new double[] {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY}, none, 0);
        assertEquals(Double.NEGATIVE_INFINITY, Simplex.logSumExp(new double[0]), 0);
    }

    @Test
    void argmaxIsTheFirstOfEqual() {
        assertEquals(1, Simplex.argmax(new double[] {0.2, 0.4, 0.4}, 3));
        assertEquals(0, Simplex.argmax(new double[] {0.2, 0.4, 0.4}, 1));
        assertEquals(-1, Simplex.argmax(new double[] {1}, 0));
    }

    @Test
    void quantilesFollowTheCumulativeSums() {
        double[] p = {0, 0.25, 0, 0.75, 0};
        assertEquals(1, Simplex.quantile(p, 5, 0), "never an outcome of probability 0");
        assertEquals(1, Simplex.quantile(p, 5, 0.2499));
        assertEquals(3, Simplex.quantile(p, 5, 0.2501));
        assertEquals(3, Simplex.quantile(p, 5, Math.nextDown(1.0)));
        assertEquals(-1, Simplex.quantile(new double[] {0, 0}, 2, 0.5), "nothing to draw");
    }

    /** False alarm in one of a million seeds. */
    @Test
    void samplesFitTheirProbabilities() {
        double[] p = {0.5, 0, 0.3, 0.15, 0.05};
        long[] counts = new long[5];
        SplittableRandom random = new SplittableRandom(18);
        for (int k = 0; k < 50_000; k++) {
            counts[Simplex.sample(p, 5, random)]++;
        }
        GoodnessOfFit.assertFits("Simplex.sample", counts, p, 1e-6);
    }
}
