package handover.simulation;

import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Time that passes only from one event to the next. Events happen in the order of their times; of those at the same time, in
 * the order in which they were planned. Used by one thread.
 */
final class VirtualClock {
    private final PriorityQueue<Event> events =
            new PriorityQueue<>(Comparator.comparingDouble(Event::time).thenComparingLong(Event::number));
    private double now;
    private long planned;

    private record Event(double time, long number, Runnable what) {}

    /** Seconds since the start; never falls. */
    double now() {
        return now;
    }

    /**
     * Plans an event.
     *
     * @param time seconds since the start, not before now
     * @throws IllegalArgumentException if this is in the past, or no time
     */
    void at(double time, Runnable what) {
        if (!(time >= now && time < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("expected a time of at least " + now + " s, got " + time);
        }
        events.add(new Event(time, planned++, what));
    }

    /**
     * Goes on to the next time at which something happens, and lets all of it happen, also what it causes at once.
     *
     * @return false if nothing is planned
     */
    boolean advance() {
        if (events.isEmpty()) {
            return false;
        }
        now = events.peek().time;
        while (!events.isEmpty() && events.peek().time == now) {
            events.poll().what.run();
        }
        return true;
    }

    /**
     * Lets all happen that is planned up to a time.
     *
     * @param time seconds since the start
     */
    void advanceTo(double time) {
        while (!events.isEmpty() && events.peek().time <= time) {
            advance();
        }
        now = Math.max(now, time);
    }
}
