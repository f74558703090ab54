package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;

/** The report's section 2.3: the linear score wants certainty, the proper ones want h = b. */
class BestExpectationTest {
    private static double[] belief(long seed, int n) {
        double[] p = new SplittableRandom(seed).doubles(n).map(u -> 0.01 + u).toArray();
        double sum = Arrays.stream(p).sum();
        return Arrays.stream(p).map(x -> x / sum).toArray();
    }

    @Property(tries = 50)
    void linearPutsAllOnTheLikeliest(@ForAll @LongRange(min = 0, max = 1_000_000) long seed, @ForAll @IntRange(min = 2, max = 6) int n) {
        double[] b = belief(seed, n);
        assertArrayEquals(Simplex.vertex(n, Simplex.argmax(b, n)), BestExpectation.of(MatchScore.LINEAR, b), 1e-6);
    }

    @Property(tries = 50)
    void brierWantsTheTruth(@ForAll @LongRange(min = 0, max = 1_000_000) long seed, @ForAll @IntRange(min = 2, max = 6) int n) {
        double[] b = belief(seed, n);
        assertArrayEquals(b, BestExpectation.of(MatchScore.BRIER, b), 1e-6);
    }

    /** The logarithm of h_eps wants h_eps = b, that is h = (b - 1e-3/N) / (1 - 1e-3). */
    @Property(tries = 50)
    void logWantsTheTruthUpToItsSmoothing(@ForAll @LongRange(min = 0, max = 1_000_000) long seed, @ForAll @IntRange(min = 2, max = 6) int n) {
        double[] b = belief(seed, n);
        double[] h = BestExpectation.of(MatchScore.LOG, b);
        for (int i = 0; i < n; i++) {
            assertEquals((b[i] - 1e-3 / n) / (1 - 1e-3), h[i], 1e-5);
        }
    }
}
