package handover.belief;

import handover.domain.ActEffect;
import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.List;

/**
 * log p(speech | i) for each object in a step in which content words or an answer may already have been heard (MODEL 4.1,
 * 4.4). Used once, by one thread.
 */
final class Weighing {
    private final ActEffect step;
    private final double[] human;
    private final boolean contentSettled;
    private final boolean answerSettled;
    private boolean uninformative;

    /**
     * @param human h after the act, not modified
     * @param contentSettled whether it is already accounted for that content words came
     * @param answerSettled the same of an answer
     */
    Weighing(ActEffect step, double[] human, boolean contentSettled, boolean answerSettled) {
        this.step = step;
        this.human = human;
        this.contentSettled = contentSettled;
        this.answerSettled = answerSettled;
    }

    /** Whether some part was left out because nobody could have said it. */
    boolean uninformative() {
        return uninformative;
    }

    /** Whether a yes or no means anything in this step. */
    boolean answerable() {
        return !answerSettled && (Arrays.stream(step.answers().yes()).anyMatch(p -> p > 0) || Arrays.stream(step.answers().no()).anyMatch(p -> p > 0));
    }

    double[] logLikelihood(Speech speech) {
        boolean weighContent = !contentSettled && speech.mayHaveContent();
        boolean weighAnswer = speech.mayHaveAnswer() && answerable();
        uninformative |= speech.mayHaveAnswer() && !weighAnswer;
        List<Speech.Alternative> alternatives = speech.alternatives();
        double[][] words = new double[alternatives.size()][human.length];
        boolean possible = false;
        for (int k = 0; k < words.length; k++) {
            Utterance said = alternatives.get(k).utterance();
            possible |= HumanModel.addLogWords(step.during().scene(), step.reference(), said, words[k]);
        }
        uninformative |= !possible;
        double[] counts = HumanModel.logWordCounts(step.during().scene().domain(), alternatives);
        double[][] logs = new double[human.length][words.length];
        for (int k = 0; k < words.length; k++) {
            double[] log = parts(alternatives.get(k).utterance(), weighContent && possible, weighAnswer);
            for (int i = 0; i < log.length; i++) {
                logs[i][k] = Math.log(alternatives.get(k).confidence()) + counts[k] + log[i]
                        + (possible ? words[k][i] : 0);
            }
        }
        return Arrays.stream(logs).mapToDouble(Simplex::logSumExp).toArray();
    }

    /** What silence about the parts that did not come says. */
    double[] logLikelihoodOfSilence() {
        return parts(Utterance.SILENCE, !contentSettled, answerable());
    }

    /** log p of whether words and which answer came, without the words themselves. */
    private double[] parts(Utterance said, boolean weighContent, boolean weighAnswer) {
        double[] log = new double[human.length];
        if (weighContent) {
            add(contentRates(said.hasContent()), log);
        }
        if (weighAnswer) {
            double[] answers = new double[human.length];
            Arrays.setAll(answers, i -> Math.log(step.answers(said.answer())[i]));
            add(answers, log);
        }
        return log;
    }

    private double[] contentRates(boolean spoke) {
        HandoverDomain domain = step.during().scene().domain();
        ActType type = step.model().type();
        double[] log = new double[human.length];
        for (int i = 0; i < log.length; i++) {
            double rate = domain.contentRate(type, human[i]);
            log[i] = Math.log(spoke ? rate : 1 - rate);
        }
        return log;
    }

    /** Adds a part to the log likelihood (modified) unless it is impossible whatever is wanted. */
    private void add(double[] part, double[] log) {
        if (Arrays.stream(part).allMatch(p -> p == Double.NEGATIVE_INFINITY)) {
            uninformative = true;
            return;
        }
        for (int i = 0; i < log.length; i++) {
            log[i] += part[i];
        }
    }
}
