package handover.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.hipparchus.distribution.continuous.ChiSquaredDistribution;

/** Tests of samples against distributions. Each fails for a right sampler with at most (about) the stated probability. */
public final class GoodnessOfFit {
    private static final double LEAST_EXPECTED = 10;

    private GoodnessOfFit() {}

    /**
     * Pearson's chi-square test. Outcomes that are expected fewer than 10 times are counted together; one of probability 0
     * must not occur at all.
     *
     * @param probabilities of all outcomes, summing to 1
     */
    public static <K> void assertFits(String what, Map<K, Long> counts, Map<K, Double> probabilities, double falseAlarm) {
        long n = counts.values().stream().mapToLong(c -> c).sum();
        counts.keySet().forEach(k -> assertTrue(probabilities.getOrDefault(k, 0.0) > 0,
                () -> what + ": drew the impossible " + k));
        assertEquals(1, probabilities.values().stream().mapToDouble(p -> p).sum(), 1e-6, what + ": sum");
        double statistic = 0;
        int cells = 0;
        double rest = 0;
        long restCount = 0;
        for (Map.Entry<K, Double> e : probabilities.entrySet()) {
            double expected = n * e.getValue();
            long count = counts.getOrDefault(e.getKey(), 0L);
            if (expected < LEAST_EXPECTED) {
                rest += expected;
                restCount += count;
            } else {
                statistic += (count - expected) * (count - expected) / expected;
                cells++;
            }
        }
        if (rest >= LEAST_EXPECTED) {
            statistic += (restCount - rest) * (restCount - rest) / rest;
            cells++;
        }
        assertTrue(rest >= LEAST_EXPECTED || restCount < 60, what + ": rare outcomes came " + restCount + " times");
        if (cells > 1) {
            double odds = 1 - new ChiSquaredDistribution(cells - 1).cumulativeProbability(statistic);
            double found = statistic;
            assertTrue(odds >= falseAlarm, () -> what + ": chi-square " + found + ", odds " + odds + "; drew " + counts
                    + " where " + probabilities + " was expected, n = " + n);
        }
    }

    /** As above for outcomes 0, 1, .... */
    public static void assertFits(String what, long[] counts, double[] probabilities, double falseAlarm) {
        Map<Integer, Long> drawn = new HashMap<>();
        Map<Integer, Double> expected = new HashMap<>();
        for (int k = 0; k < counts.length; k++) {
            expected.put(k, probabilities[k]);
            if (counts[k] > 0) {
                drawn.put(k, counts[k]);
            }
        }
        assertFits(what, drawn, expected, falseAlarm);
    }

    /**
     * Kolmogorov and Smirnov's distance, with the bound of Dvoretzky, Kiefer, Wolfowitz and Massart, for every n.
     *
     * @param sample modified: sorted
     */
    public static void assertFollows(String what, double[] sample, DoubleUnaryOperator cumulative, double falseAlarm) {
        Arrays.sort(sample);
        double n = sample.length;
        double distance = 0;
        double where = 0;
        for (int k = 0; k < n; k++) {
            double f = cumulative.applyAsDouble(sample[k]);
            double d = Math.max(Math.abs(f - k / n), Math.abs(f - (k + 1) / n));
            where = d > distance ? sample[k] : where;
            distance = Math.max(distance, d);
        }
        double bound = Math.sqrt(Math.log(2 / falseAlarm) / (2 * n));
        assertTrue(distance <= bound, what + ": distance " + distance + " at " + where + ", allowed " + bound);
    }
}
