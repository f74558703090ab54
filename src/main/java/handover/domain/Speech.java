package handover.domain;

import java.util.List;

/**
 * One utterance as a recogniser heard it: its n-best list. Immutable.
 *
 * @param alternatives at least one, with confidences that sum to one
 */
public record Speech(List<Alternative> alternatives) {

    /**
     * One reading of what was said.
     *
     * @param utterance the transcript, taken apart
     * @param confidence q_k in [0, 1]
     */
    public record Alternative(Utterance utterance, double confidence) {}

    /** Normalises the confidences; if they are all 0 the alternatives count the same. */
    public Speech {
        double sum = alternatives.stream().mapToDouble(Alternative::confidence).sum();
        double n = alternatives.size();
        alternatives = alternatives.stream()
                .map(a -> new Alternative(a.utterance, sum > 0 ? a.confidence / sum : 1 / n)).toList();
    }

    /** Speech that was heard for certain. */
    public static Speech of(Utterance utterance) {
        return new Speech(List.of(new Alternative(utterance, 1)));
    }

    /** A final transcript. */
    public static Speech of(String transcript, Vocabulary vocabulary) {
        return of(Utterance.parse(transcript, vocabulary));
    }

    /** The answer that more than half of the confidence is on, else none. */
    public Answer answer() {
        for (Answer answer : List.of(Answer.YES, Answer.NO)) {
            double q = alternatives.stream().filter(a -> a.utterance.answer() == answer)
                    .mapToDouble(Alternative::confidence).sum();
            if (q > 0.5) {
                return answer;
            }
        }
        return Answer.NONE;
    }

    /** Whether any reading has words that describe the wanted object. */
    public boolean mayHaveContent() {
        return alternatives.stream().anyMatch(a -> a.utterance.hasContent());
    }

    /** Whether any reading has an answer. */
    public boolean mayHaveAnswer() {
        return alternatives.stream().anyMatch(a -> a.utterance.answer() != Answer.NONE);
    }
}
