package handover.simulation;

import handover.belief.BeliefTracker;
import handover.belief.HandoverBelief;
import handover.belief.Timeline;
import handover.domain.Act;
import handover.domain.PickSignal;

/**
 * The robot's belief, moved by what it does and by what arrives: a {@link Timeline} that forgets nothing, so that evidence is
 * weighed against the act that was under way when it was said or shown, however late it arrives. Each change makes a new version.
 * Used by one thread.
 */
final class TimedFilter {
    private static final double MEMORY = Double.POSITIVE_INFINITY;

    private Timeline timeline;
    /** The act that started last, null before the first. */
    private Act last;
    private long version;

    /** A belief before any act. */
    TimedFilter(HandoverBelief belief) {
        timeline = Timeline.of(BeliefTracker.of(belief));
    }

    /** How often the belief changed. */
    long version() {
        return version;
    }

    /** The belief; the step under way is open. */
    HandoverBelief now() {
        return timeline.now().now();
    }

    /** What is believed if nothing more comes before the next act: the step under way is closed, unless there was no act yet. */
    HandoverBelief settled() {
        return last == null ? now() : now().closed();
    }

    /** An act starts. Throws {@link IllegalArgumentException} if it is not legal. */
    void started(double time, Act act) {
        to(timeline.acted(time, t -> t.started(act), MEMORY));
        last = act;
    }

    /** Something is reported. */
    void sensed(Arrival arrival) {
        to(timeline.sensed(arrival.at(), arrival.arrives(), arrival::correct, MEMORY));
    }

    /** The last act that started is over, with what became of it if it is a pick. */
    void ended(double time, PickSignal signal) {
        Act act = last;
        to(timeline.acted(time, t -> t.completed(act, signal), MEMORY));
    }

    private void to(Timeline next) {
        version += next.now().now() == now() ? 0 : 1;
        timeline = next;
    }
}
