package handover.simulation;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * What many timed episodes of one solver and agent were worth, with 95% intervals. Immutable.
 *
 * @param success share of episodes whose first completed pick was right
 * @param seconds to handover, thinking included; an episode that hit the step limit counts with the time that it took
 * @param idle seconds without an act in an episode
 * @param steps number of acts
 * @param discountedReturn sum of gamma^t r_t
 * @param plannings started for each act
 * @param stale share of acts that were decided on a belief which had changed when they started
 * @param differing share of acts that would have been others on the belief of their start
 * @param correctCancels in an episode, reaches for something else that were called off
 * @param falseCancels in an episode, reaches for the wanted object that were called off
 * @param objections in an episode, reaches for something else to which the human said no
 * @param heeded share of the objections after which the reach was called off; NaN without objections
 * @param actsToCancel of those, from the act to which they said no to another act; NaN if there is none
 * @param secondsToCancel of those, from the end of the "no" to the start of another act; NaN if there is none
 */
public record TimedSummary(Estimate success, Estimate seconds, Estimate idle, Estimate steps, Estimate discountedReturn,
        double plannings, double stale, double differing, double correctCancels, double falseCancels, double objections, double heeded,
        Estimate actsToCancel, Estimate secondsToCancel) {

    /** Summarises at least one episode. */
    public static TimedSummary of(List<TimedMeasures> episodes) {
        double acts = sum(episodes, e -> e.measures().steps());
        double objections = sum(episodes, e -> e.reaches().objections());
        List<TimedMeasures.Cancel> cancels = episodes.stream().flatMap(e -> e.cancels().stream()).toList();
        return new TimedSummary(
                Estimate.share((int) episodes.stream().filter(e -> e.measures().success()).count(), episodes.size()),
                mean(episodes, e -> e.measures().seconds()), mean(episodes, TimedMeasures::idle),
                mean(episodes, e -> e.measures().steps()), mean(episodes, e -> e.measures().discountedReturn()),
                sum(episodes, TimedMeasures::plannings) / acts, sum(episodes, TimedMeasures::stale) / acts,
                sum(episodes, TimedMeasures::differing) / acts,
                sum(episodes, e -> e.reaches().correctCancels()) / episodes.size(),
                sum(episodes, e -> e.reaches().falseCancels()) / episodes.size(), objections / episodes.size(),
                cancels.size() / objections, Estimate.mean(cancels.stream().map(c -> (double) c.acts()).toList()),
                Estimate.mean(cancels.stream().map(TimedMeasures.Cancel::seconds).toList()));
    }

    /** The mean difference, first minus second, over the episodes that both played. */
    public static Estimate difference(List<TimedMeasures> first, List<TimedMeasures> second, ToDoubleFunction<Measures> of) {
        int n = Math.min(first.size(), second.size());
        return Estimate.mean(IntStream.range(0, n)
                .mapToObj(k -> of.applyAsDouble(first.get(k).measures()) - of.applyAsDouble(second.get(k).measures())).toList());
    }

    private static Estimate mean(List<TimedMeasures> episodes, ToDoubleFunction<TimedMeasures> of) {
        return Estimate.mean(episodes.stream().map(of::applyAsDouble).toList());
    }

    private static double sum(List<TimedMeasures> episodes, ToDoubleFunction<TimedMeasures> of) {
        return episodes.stream().mapToDouble(of).sum();
    }
}
