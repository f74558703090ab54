package handover.simulation;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * What many episodes of one solver were worth, with 95% intervals. Immutable.
 *
 * @param solver its name
 * @param episodes how many
 * @param success share of episodes whose first completed pick was right
 * @param handedOver share of episodes that ended with everything handed over
 * @param seconds to handover; an episode that hit the step limit counts with the time that it took
 * @param steps number of acts
 * @param discountedReturn sum of gamma^t r_t
 * @param questions number of ASK
 * @param logScore of b, nats
 * @param brierScore of b
 * @param distance between h and b, L1
 * @param p50 median decision time, seconds
 * @param p99 99th percentile of the decision time, seconds
 */
public record Summary(String solver, int episodes, Estimate success, Estimate handedOver, Estimate seconds, Estimate steps,
        Estimate discountedReturn, Estimate questions, Estimate logScore, Estimate brierScore, Estimate distance,
        double p50, double p99) {

    /** Summarises at least one episode of one solver. */
    public static Summary of(List<Episode> episodes) {
        int n = episodes.size();
        long[] nanos = episodes.stream().flatMapToLong(e -> Arrays.stream(e.decisionNanos())).sorted().toArray();
        return new Summary(episodes.get(0).solver(), n,
                Estimate.share((int) episodes.stream().filter(e -> e.measures().success()).count(), n),
                Estimate.share((int) episodes.stream().filter(e -> e.measures().handedOver()).count(), n),
                mean(episodes, Measures::seconds), mean(episodes, Measures::steps),
                mean(episodes, Measures::discountedReturn), mean(episodes, Measures::questions),
                mean(episodes, Measures::logScore), mean(episodes, Measures::brierScore),
                mean(episodes, Measures::distance), percentile(nanos, 0.5), percentile(nanos, 0.99));
    }

    /** The mean difference in return, first minus second, over the episodes that both played. */
    public static Estimate returnDifference(List<Episode> first, List<Episode> second) {
        int n = Math.min(first.size(), second.size());
        return Estimate.mean(IntStream.range(0, n).mapToObj(k -> first.get(k).measures().discountedReturn()
                - second.get(k).measures().discountedReturn()).toList());
    }

    private static Estimate mean(List<Episode> episodes, ToDoubleFunction<Measures> of) {
        return Estimate.mean(episodes.stream().map(e -> of.applyAsDouble(e.measures())).toList());
    }

    /** Nearest-rank percentile in seconds; NaN if there is nothing. */
    private static double percentile(long[] sortedNanos, double p) {
        return sortedNanos.length == 0 ? Double.NaN
                : sortedNanos[(int) Math.max(0, Math.ceil(p * sortedNanos.length) - 1)] / 1e9;
    }
}
