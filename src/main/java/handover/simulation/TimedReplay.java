package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.PickSignal;

/**
 * The beliefs of a timed episode, computed again from what was done and sensed and when; equal to those of the episode to the
 * last bit, for either {@link Agent}. Used by one thread.
 */
public final class TimedReplay {
    private final VirtualClock clock = new VirtualClock();
    private final TimedFilter filter;

    /** A belief before any act. */
    public TimedReplay(HandoverBelief start) {
        this.filter = new TimedFilter(start);
    }

    /**
     * The next act.
     *
     * @param signal what became of it if it is a pick
     * @param time which does not start before the last act was over
     * @throws IllegalArgumentException if the act is not legal
     */
    public void started(Act act, PickSignal signal, TimedStep time) {
        clock.advanceTo(time.start());
        filter.started(time.start(), act);
        clock.at(time.end(), () -> filter.ended(time.end(), signal));
        time.arrivals().forEach(a -> clock.at(a.arrives(), () -> filter.sensed(a)));
    }

    /**
     * What was believed at a time if nothing more came before the next act.
     *
     * @param time seconds since the start, not before the last act was over
     * @throws IllegalArgumentException if a pick completed and its signal does not say how
     */
    public HandoverBelief settled(double time) {
        clock.advanceTo(time);
        return filter.settled();
    }
}
