package handover.belief;

import handover.domain.Act;
import handover.domain.AskType;
import handover.domain.Gesture;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import java.util.function.UnaryOperator;

/**
 * Follows a real robot: the belief moves with what it did and with what is sensed, event by event (docs/bridge.md,
 * {@code acted}). What may have to be undone is followed beside it, so that the size does not depend on how much was sensed.
 * Immutable, thread safe; every method returns the next tracker.
 *
 * @param now the belief
 * @param undone the belief if the question under way is not finished, as if it had never started; null if no question is
 * @param stalled the belief if the increment under way does not advance; null if it surely does
 * @param act the act under way, null if none
 */
public record BeliefTracker(HandoverBelief now, HandoverBelief undone, HandoverBelief stalled, Act act) {

    /** A tracker before the first act. */
    public static BeliefTracker of(HandoverBelief belief) {
        return new BeliefTracker(belief, null, null, null);
    }

    public BeliefTracker heard(Speech speech) {
        return each(b -> b.heard(speech));
    }

    public BeliefTracker saw(Gesture gesture) {
        return each(b -> b.saw(gesture));
    }

    /** The table changed; an act under way about something that is gone is given up. */
    public BeliefTracker on(Scene scene) {
        BeliefTracker moved = each(b -> b.on(scene));
        return act == null || scene.model(act) != null ? moved : of(moved.now);
    }

    private BeliefTracker each(UnaryOperator<HandoverBelief> event) {
        return new BeliefTracker(event.apply(now), undone == null ? null : event.apply(undone),
                stalled == null ? null : event.apply(stalled), act);
    }

    /** The robot starts an act. Throws {@link IllegalArgumentException} if it is not legal. */
    public BeliefTracker started(Act next) {
        HandoverBelief after = now.after(next);
        HandoverBelief other = after.stalled();
        return new BeliefTracker(after, next.verb().equals(AskType.VERB) ? now : null,
                other.task().equals(after.task()) ? null : other, next);
    }

    /**
     * The robot finished an act, which is taken as started too if that was not reported. What was said before an object was
     * accepted was about that object; the next wish starts without it.
     *
     * @param signal what became of a pick
     * @throws IllegalArgumentException if the act is not legal, or if it completes a pick and the signal does not say
     *     whether the object was accepted
     */
    public BeliefTracker completed(Act done, PickSignal signal) {
        BeliefTracker t = done.equals(act) ? this : started(done);
        boolean decided = signal == PickSignal.ACCEPTED || signal == PickSignal.REJECTED;
        HandoverBelief moved = signal == PickSignal.NONE && t.stalled != null ? t.stalled : t.now;
        if (moved.pickPending() && !decided) {
            throw new IllegalArgumentException("expected accepted or rejected, because this completes the pick of "
                    + t.now.task().target());
        }
        boolean picks = decided && moved.task().target() != null;
        return of(picks ? moved.picked(signal == PickSignal.ACCEPTED) : moved);
    }

    /**
     * The robot could not finish an act, or broke it off. An unfinished question was not understood: it is undone, what
     * was sensed meanwhile counts for the step before. A movement was seen: what it told the human stays, a pick is given
     * up. If the act never started, nothing changes.
     */
    public BeliefTracker abandoned(Act given) {
        if (!given.equals(act)) {
            return this;
        }
        return of(undone != null ? undone : now.cancelled());
    }
}
