package handover.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;

/** Random streams: reproducible, and crudely independent across roles, indices and seeds. */
class StreamsTest {
    private static final int N = 20_000;
    /** |correlation| of N independent pairs exceeds 5.2 / sqrt(N) with odds of 2e-7. */
    private static final double MOST = 5.2 / Math.sqrt(N);

    @Test
    void theSameNameIsTheSameStream() {
        RandomGenerator a = Streams.of(7, "human", 3);
        RandomGenerator b = Streams.of(7, "human", 3);
        for (int k = 0; k < 100; k++) {
            assertEquals(a.nextLong(), b.nextLong(), "draw " + k);
        }
    }

    @Test
    void firstDrawsOfSuccessiveEpisodesAreUniform() {
        for (String role : List.of("human", "nature", "planner")) {
            double[] u = new double[N];
            for (int k = 0; k < N; k++) {
                u[k] = Streams.of(1, role, k).nextDouble();
            }
            GoodnessOfFit.assertFollows("first draws of " + role, u, x -> x, 1e-6);
        }
    }

    @Test
    void neighboursAreUncorrelated() {
        assertUncorrelated("roles", k -> new double[] {first(1, "human", k), first(1, "nature", k)});
        assertUncorrelated("episodes", k -> new double[] {first(1, "human", k), first(1, "human", k + 1)});
        assertUncorrelated("seeds", k -> new double[] {first(k, "human", 0), first(k + 1, "human", 0)});
        assertUncorrelated("seed and episode", k -> new double[] {first(k, "human", 5), first(5, "human", k)});
        RandomGenerator human = Streams.of(1, "human", 0);
        RandomGenerator nature = Streams.of(1, "nature", 0);
        assertUncorrelated("draws in parallel", k -> new double[] {human.nextDouble(), nature.nextDouble()});
    }

    private static double first(long seed, String role, long index) {
        return Streams.of(seed, role, index).nextDouble();
    }

    private interface Pairs {
        double[] pair(int k);
    }

    private static void assertUncorrelated(String what, Pairs pairs) {
        double sum = 0;
        for (int k = 0; k < N; k++) {
            double[] p = pairs.pair(k);
            sum += (p[0] - 0.5) * (p[1] - 0.5) * 12;
        }
        double r = sum / N;
        assertTrue(Math.abs(r) < MOST, () -> what + ": correlation " + r);
    }

    @Test
    void seedsDoNotCollide() {
        Set<Long> seen = new HashSet<>();
        for (int a = 0; a < 200; a++) {
            for (int b = 0; b < 200; b++) {
                assertTrue(seen.add(Streams.mix(a, b)), "mix(" + a + ", " + b + ") came before");
            }
        }
    }

    @Test
    void aSeededGeneratorIsSplitMix64() {
        SeededRandom random = new SeededRandom();
        for (long seed : new long[] {0, 1, -5, Long.MAX_VALUE}) {
            random.seed(seed);
            SplittableRandom expected = new SplittableRandom(seed);
            for (int k = 0; k < 20; k++) {
                assertEquals(expected.nextLong(), random.nextLong(), "seed " + seed + ", draw " + k);
            }
        }
        double[] u = new double[N];
        for (int k = 0; k < N; k++) {
            random.seed(k);
            u[k] = random.nextDouble();
        }
        GoodnessOfFit.assertFollows("first draws of successive seeds", u, x -> x, 1e-6);
    }
}
