package handover.belief;

import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.List;

/**
 * log p(speech | i, mind) for each mind and object in a step in which content words or an answer may already have been heard
 * (MODEL 4.1, 4.4). Answers and contrast are about what was perceived, the rates are those of the act that was done. Used
 * once, by one thread.
 */
final class Weighing {
    private final Scene scene;
    private final ActType type;
    private final List<Mind> minds;
    private final int n;
    private final boolean contentSettled;
    private final boolean answerSettled;
    private boolean uninformative;

    /**
     * @param type of the act that was done
     * @param minds that the human may be in after the act, at least one
     * @param contentSettled whether it is already accounted for that content words came
     * @param answerSettled the same of an answer
     */
    Weighing(Scene scene, ActType type, List<Mind> minds, boolean contentSettled, boolean answerSettled) {
        this.scene = scene;
        this.type = type;
        this.minds = minds;
        this.n = scene.size();
        this.contentSettled = contentSettled;
        this.answerSettled = answerSettled;
    }

    /** Whether some part was left out because nobody could have said it. */
    boolean uninformative() {
        return uninformative;
    }

    /** Whether a yes or no means anything in this step. */
    boolean answerable() {
        return !answerSettled && minds.stream().map(m -> m.step().answers())
                .anyMatch(a -> Arrays.stream(a.yes()).anyMatch(p -> p > 0) || Arrays.stream(a.no()).anyMatch(p -> p > 0));
    }

    /** One row per mind, one entry per object. */
    double[][] logLikelihood(Speech speech) {
        boolean weighContent = !contentSettled && speech.mayHaveContent();
        boolean weighAnswer = speech.mayHaveAnswer() && answerable();
        uninformative |= speech.mayHaveAnswer() && !weighAnswer;
        List<Speech.Alternative> alternatives = speech.alternatives();
        double[][][] words = new double[alternatives.size()][][];
        boolean possible = false;
        for (int k = 0; k < words.length; k++) {
            words[k] = new double[minds.size()][];
            possible |= addLogWords(alternatives.get(k).utterance(), words[k]);
        }
        uninformative |= !possible;
        double[] counts = HumanModel.logWordCounts(scene.domain(), alternatives);
        double[][][] logs = new double[minds.size()][n][words.length];
        for (int k = 0; k < words.length; k++) {
            double[][] log = parts(alternatives.get(k).utterance(), weighContent && possible, weighAnswer);
            double before = Math.log(alternatives.get(k).confidence()) + counts[k];
            for (int m = 0; m < log.length; m++) {
                for (int i = 0; i < n; i++) {
                    logs[m][i][k] = before + log[m][i] + (possible ? words[k][m][i] : 0);
                }
            }
        }
        return Arrays.stream(logs).map(row -> Arrays.stream(row).mapToDouble(Simplex::logSumExp).toArray())
                .toArray(double[][]::new);
    }

    /** log p(words | i) for each mind, into {@code out}; minds share it unless words depend on what is open. */
    private boolean addLogWords(Utterance said, double[][] out) {
        boolean contrast = scene.domain().spec().speech().contrast() > 0;
        boolean possible = false;
        for (int m = 0; m < out.length; m++) {
            out[m] = m == 0 || contrast ? new double[n] : out[0];
            possible |= (m == 0 || contrast) && HumanModel.addLogWords(scene, minds.get(m).step().reference(), said, out[m]);
        }
        return possible;
    }

    /** What silence about the parts that did not come says; one row per mind. */
    double[][] logLikelihoodOfSilence() {
        return parts(Utterance.SILENCE, !contentSettled, answerable());
    }

    /** log p of whether words and which answer came, without the words themselves. */
    private double[][] parts(Utterance said, boolean weighContent, boolean weighAnswer) {
        double[][] log = new double[minds.size()][n];
        if (weighContent) {
            add(contentRates(said.hasContent()), log);
        }
        if (weighAnswer) {
            add(answers(said.answer()), log);
        }
        return log;
    }

    private double[][] answers(Answer answer) {
        return minds.stream().map(m -> LogWeights.log(m.step().answers(answer))).toArray(double[][]::new);
    }

    private double[][] contentRates(boolean spoke) {
        HandoverDomain domain = scene.domain();
        double[][] log = new double[minds.size()][n];
        for (int m = 0; m < log.length; m++) {
            for (int i = 0; i < n; i++) {
                double rate = domain.contentRate(type, minds.get(m).human()[i]);
                log[m][i] = Math.log(spoke ? rate : 1 - rate);
            }
        }
        return log;
    }

    /** Adds a part to the log likelihood (modified) unless it is impossible whatever is wanted and whatever was perceived. */
    private void add(double[][] part, double[][] log) {
        if (Arrays.stream(part).allMatch(row -> Arrays.stream(row).allMatch(p -> p == Double.NEGATIVE_INFINITY))) {
            uninformative = true;
            return;
        }
        for (int m = 0; m < log.length; m++) {
            for (int i = 0; i < n; i++) {
                log[m][i] += part[m][i];
            }
        }
    }
}
