package handover.domain;

import java.util.Arrays;
import java.util.List;

/**
 * Who would answer what: for each object that may be wanted, the probabilities of yes, no and no answer. Immutable, thread
 * safe; arrays must not be modified.
 *
 * @param yes P(yes | i)
 * @param no P(no | i)
 * @param none P(no answer | i)
 */
public record Answers(double[] yes, double[] no, double[] none) {

    /** Nobody answers. */
    static Answers silence(int n) {
        double[] surely = new double[n];
        Arrays.fill(surely, 1);
        return new Answers(new double[n], new double[n], surely);
    }

    /** To an act of this type that is taken to mean object i with probability {@code match[i]}. */
    static Answers to(HandoverDomain domain, ActType type, double[] match) {
        double[][] p = new double[Answer.values().length][match.length];
        for (Answer answer : Answer.values()) {
            Arrays.setAll(p[answer.ordinal()], i -> domain.answerProbability(answer, type, match[i]));
        }
        return new Answers(p[Answer.YES.ordinal()], p[Answer.NO.ordinal()], p[Answer.NONE.ordinal()]);
    }

    /** A mixture with these weights. */
    static Answers average(List<Answers> parts, double[] weights) {
        double[][] p = new double[Answer.values().length][parts.get(0).yes.length];
        for (Answer answer : Answer.values()) {
            for (int k = 0; k < weights.length; k++) {
                for (int i = 0; i < p[answer.ordinal()].length; i++) {
                    p[answer.ordinal()][i] += weights[k] * parts.get(k).of(answer)[i];
                }
            }
        }
        return new Answers(p[Answer.YES.ordinal()], p[Answer.NO.ordinal()], p[Answer.NONE.ordinal()]);
    }

    /** P(answer | i) for each object i. */
    public double[] of(Answer answer) {
        return switch (answer) {
            case YES -> yes;
            case NO -> no;
            case NONE -> none;
        };
    }
}
