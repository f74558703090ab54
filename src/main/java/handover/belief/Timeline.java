package handover.belief;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.UnaryOperator;

/**
 * A tracker that also takes what was sensed before the last act but arrived after it: it is weighed in the step in which it was
 * sensed, after what had arrived there before, and what followed is computed again. Remembers what happened since the first act
 * of the last {@code memory} seconds. Immutable, thread safe.
 */
public final class Timeline {
    private static final int MOST = 1000;

    private final BeliefTracker now;
    /** The newest event that is remembered; null if none is. */
    private final Event last;
    /** How many are remembered. */
    private final int events;
    /** When the last act happened, in seconds; negative infinity if that does not matter any more. */
    private final double lastAct;
    /** What was sensed before this belongs to no step that is known, in seconds. */
    private final double first;
    /** How many may be remembered. */
    private final int most;

    /** The event is older than what can still be weighed. */
    public static final class StaleException extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    /**
     * Something that happened.
     *
     * @param t when, in seconds; only looked at if it is an act
     * @param act whether it is something that the robot did or that happened to the table
     * @param before the tracker before it
     * @param previous what happened before; null if that is forgotten
     */
    private record Event(double t, boolean act, UnaryOperator<BeliefTracker> change, BeliefTracker before, Event previous) {
        Event after(Event other) {
            return new Event(t, act, change, before, other);
        }
    }

    private Timeline(BeliefTracker now, Event last, int events, double lastAct, double first, int most) {
        this.now = now;
        this.last = last;
        this.events = events;
        this.lastAct = lastAct;
        this.first = first;
        this.most = most;
    }

    /**
     * The beginning of an episode at the time {@code t}, of any length: nothing that was sensed before belongs to it, and at most
     * {@value #MOST} events are remembered.
     */
    public static Timeline of(BeliefTracker start, double t) {
        return new Timeline(start, null, 0, t, t, MOST);
    }

    /** The beginning of a short episode, with room for all of its events. */
    public static Timeline of(BeliefTracker start) {
        return new Timeline(start, null, 0, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Integer.MAX_VALUE);
    }

    /** The tracker after all of it. */
    public BeliefTracker now() {
        return now;
    }

    /**
     * The robot did something at the time {@code t}, or the table changed.
     *
     * @param memory seconds of which the acts are remembered; may be infinite
     */
    public Timeline acted(double t, UnaryOperator<BeliefTracker> change, double memory) {
        double at = t < lastAct ? lastAct : t;
        return append(new Event(at, true, change, now, null), change.apply(now), at).since(at - memory);
    }

    /**
     * Something was sensed at the time {@code t}.
     *
     * @param arrival when that became known
     * @param memory seconds after which it is too late
     * @throws StaleException if it is too old, or older than what is remembered
     */
    public Timeline sensed(double t, double arrival, UnaryOperator<BeliefTracker> change, double memory) {
        if (t < arrival - memory || t < first) {
            throw new StaleException();
        } else if (t < lastAct) {
            return inserted(t, change);
        } else if (!(lastAct >= arrival - memory)) {
            return new Timeline(change.apply(now), null, 0, lastAct, first, most);
        }
        return append(new Event(t, false, change, now, null), change.apply(now), lastAct);
    }

    /** Forgets when things happened, because the clock was set. */
    public Timeline timeless() {
        return new Timeline(now, null, 0, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, most);
    }

    private Timeline append(Event event, BeliefTracker next, double act) {
        if (events < most && (last != null || event.act)) {
            return new Timeline(next, event.after(last), events + 1, act, first, most);
        }
        return event.act ? new Timeline(next, event, 1, act, lastAct, most) : new Timeline(next, null, 0, act, lastAct, most);
    }

    private Timeline inserted(double t, UnaryOperator<BeliefTracker> change) {
        Deque<Event> later = new ArrayDeque<>();
        Event next = null;
        for (Event e = last; e != null && !(e.act && e.t <= t); e = e.previous) {
            later.push(e);
            next = e.act ? e : next;
        }
        if (next == null) {
            throw new StaleException();
        }
        while (later.peek() != next) {
            later.pop();
        }
        BeliefTracker tracker = change.apply(next.before);
        Event event = next.previous == null ? null : new Event(t, false, change, next.before, next.previous);
        for (Event e : later) {
            event = new Event(e.t, e.act, e.change, tracker, event);
            tracker = e.change.apply(tracker);
        }
        return new Timeline(tracker, event, next.previous == null ? events : events + 1, lastAct, first, most);
    }

    /** Without what is older than the first act since {@code t}. */
    private Timeline since(double t) {
        Deque<Event> kept = new ArrayDeque<>();
        int acts = 0;
        for (Event e = last; e != null; e = e.previous) {
            kept.push(e);
            acts += e.act && e.t >= t ? 1 : 0;
        }
        double known = first;
        while (acts > 0 && !(kept.peek().act && kept.peek().t >= t)) {
            Event forgotten = kept.pop();
            known = forgotten.act ? Math.max(known, forgotten.t) : known;
        }
        if (acts == 0 || kept.size() == events) {
            return acts == 0 ? new Timeline(now, null, 0, lastAct, first, most) : this;
        }
        Event event = null;
        for (Event e : kept) {
            event = e.after(event);
        }
        return new Timeline(now, event, kept.size(), lastAct, known, most);
    }
}
