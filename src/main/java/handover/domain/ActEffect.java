package handover.domain;

import java.util.Arrays;

/**
 * What an act does from a given {@link Task}, apart from beliefs: the task while the human reacts, its price, and who
 * would answer what. Immutable, thread safe.
 *
 * @param model the act
 * @param during the task from the act's start until the answer or the pick's outcome
 * @param reward the act's price and annoyance
 * @param completes whether a pick completes, so that the outcome is accepted or rejected and nobody answers
 * @param reference what content words are said in contrast to, null if nothing is open
 * @param answers who would answer what
 * @param advance the probability of this effect; 1 unless the act is an increment that may not advance
 * @param stalled the effect if the increment does not advance, null if it surely does
 */
public record ActEffect(ActModel model, Task during, double reward, boolean completes, ActModel reference, Answers answers,
        double advance, ActEffect stalled) {

    /** The rest of the step once the pick completed and the table is as in {@code after}: nobody answers. */
    public ActEffect once(Task after) {
        return new ActEffect(model, after, reward, false, null, after.scene().silence(), 1, null);
    }

    /** The rest of the step on another table; that of a WAIT if what the act is about is not there any more. */
    public ActEffect on(Scene other) {
        Task then = during.on(other);
        ActModel same = other.model(model.act());
        if (same == null) {
            return then.effect(Act.WAIT);
        }
        ActModel open = reference == null ? null : other.model(reference.act());
        boolean silent = Arrays.stream(answers.none()).allMatch(p -> p == 1);
        return new ActEffect(same, then, reward, completes, open,
                silent ? other.silence() : other.answers(same, open == null ? same : open), advance,
                stalled == null ? null : stalled.on(other));
    }

    /** P(answer | i) for each object i; not to be modified. */
    public double[] answers(Answer answer) {
        return answers.of(answer);
    }
}
