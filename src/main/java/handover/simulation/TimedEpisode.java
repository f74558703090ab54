package handover.simulation;

import java.util.List;

/**
 * An episode with its times. Immutable.
 *
 * @param episode its steps, in which an observation is the human's reaction to the act, whenever it arrived, and the belief is
 *     that of the moment at which the next act started; its seconds are those until the end of the last act; it has no
 *     decision times
 * @param times one for each step
 */
public record TimedEpisode(Episode episode, List<TimedStep> times) {
    public TimedEpisode {
        times = List.copyOf(times);
    }

    /** What it was worth. */
    public TimedMeasures measures() {
        Reaches reaches = Reaches.of(episode);
        List<TimedMeasures.Cancel> cancels = reaches.heeded().stream().map(this::cancel).filter(c -> c.seconds() >= 0).toList();
        return new TimedMeasures(episode.measures(), idle(), times.stream().mapToInt(TimedStep::plannings).sum(),
                (int) times.stream().filter(TimedStep::stale).count(), (int) times.stream().filter(TimedStep::differs).count(),
                reaches, cancels);
    }

    /** Seconds before the first act and between the acts. */
    private double idle() {
        double idle = 0;
        double end = 0;
        for (TimedStep t : times) {
            idle += t.start() - end;
            end = t.end();
        }
        return idle;
    }

    private TimedMeasures.Cancel cancel(Reaches.Heeded h) {
        double said = times.get(h.objected()).arrivals().stream().filter(a -> a.speech() != null).findFirst().orElseThrow().at();
        return new TimedMeasures.Cancel(h.cancelled() - h.objected(), times.get(h.cancelled()).start() - said);
    }
}
