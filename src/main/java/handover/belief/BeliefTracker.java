package handover.belief;

import handover.domain.Act;
import handover.domain.AskType;
import handover.domain.Gesture;
import handover.domain.PickSignal;
import handover.domain.Speech;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Follows a real robot: the belief moves with what it did and with what is sensed, event by event (PROTOCOL.md,
 * {@code acted}). Immutable, thread safe; every method returns the next tracker.
 *
 * @param now the belief
 * @param before the belief when the act under way started; the same as {@code now} if none is
 * @param evidence what was sensed since then
 * @param act the act under way, null if none
 */
public record BeliefTracker(HandoverBelief now, HandoverBelief before, List<UnaryOperator<HandoverBelief>> evidence,
        Act act) {

    /** A tracker before the first act. */
    public static BeliefTracker of(HandoverBelief belief) {
        return new BeliefTracker(belief, belief, List.of(), null);
    }

    public BeliefTracker heard(Speech speech) {
        return sensed(b -> b.heard(speech));
    }

    public BeliefTracker saw(Gesture gesture) {
        return sensed(b -> b.saw(gesture));
    }

    private BeliefTracker sensed(UnaryOperator<HandoverBelief> event) {
        List<UnaryOperator<HandoverBelief>> all = new ArrayList<>(evidence);
        all.add(event);
        return new BeliefTracker(event.apply(now), before, List.copyOf(all), act);
    }

    /** The robot starts an act. Throws {@link IllegalArgumentException} if it is not legal. */
    public BeliefTracker started(Act next) {
        return new BeliefTracker(now.after(next), now, List.of(), next);
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
        HandoverBelief moved = signal == PickSignal.NONE ? t.stalled() : t.now;
        if (moved.pickPending() && !decided) {
            throw new IllegalArgumentException("expected accepted or rejected, because this completes the pick of "
                    + t.now.task().target());
        }
        boolean picks = decided && moved.task().target() != null;
        HandoverBelief belief = picks ? moved.picked(signal == PickSignal.ACCEPTED) : moved;
        return new BeliefTracker(belief, belief, List.of(), null);
    }

    /** What was said while the increment was tried, weighed for one that did not advance. */
    private HandoverBelief stalled() {
        HandoverBelief other = before.after(act).stalled();
        return other.task().equals(now.task()) ? now : replay(other);
    }

    private HandoverBelief replay(HandoverBelief from) {
        HandoverBelief belief = from;
        for (UnaryOperator<HandoverBelief> event : evidence) {
            belief = event.apply(belief);
        }
        return belief;
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
        HandoverBelief belief = now.cancelled();
        if (act.verb().equals(AskType.VERB)) {
            belief = replay(before);
        }
        return new BeliefTracker(belief, belief, List.of(), null);
    }
}
