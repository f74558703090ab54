package handover.solver;

import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.AskType;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.WrongPick;
import handover.math.Simplex;
import java.util.HashMap;
import java.util.Map;

/**
 * The value of a policy that asks about one object after the other, the likeliest first, hands over the first that gets a
 * yes, and listens to nothing else. It is followed in expectation along the one path on which nobody says yes. A yes counts
 * as it does on average over what the human may take the question for. Its match part, which is small, is that of a human who
 * expects nothing in particular before each question, and 0 for the pick that follows a yes. Used by one thread at a time.
 */
final class AskInTurn {
    /** Longer paths are not followed. */
    private static final int MOST_QUESTIONS = 24;
    /** What is left of the path when it is not worth following. */
    private static final double NEGLIGIBLE = 0.02;

    private final HandoverDomain domain;
    private final int n;
    /** By object; null if there are no questions. */
    private final ActModel[] asks;
    /** What a human who expected nothing in particular expects after each question. */
    private final double[][] human;
    private final double[] left;
    private final double[] posterior;
    private final double tau;
    /** The probability that a wish becomes a certain other one. */
    private final double drift;
    /** What reaching for each object comes to. */
    private final double[] pickPrice;
    private final double lastDiscount;
    private final boolean wrongEnds;
    /** Nothing is open yet. */
    private final Turn start;
    private final Map<Task, Turn> turns = new HashMap<>();
    private final double mostRepeated;

    /** Where the path may stand, with the questions from there, filled on demand. */
    private record Turn(Task task, Question[] questions) {}

    /** @param yes P(yes | i) */
    private record Question(double reward, double[] yes, Turn next) {}

    AskInTurn(Scene scene) {
        domain = scene.domain();
        n = scene.size();
        asks = new ActModel[n];
        human = new double[n][];
        for (int i = 0; i < n; i++) {
            asks[i] = scene.model(Act.of(AskType.VERB, scene.objects().get(i).name()));
            human[i] = asks[i] == null ? null : domain.understood(asks[i], Simplex.uniform(n));
        }
        tau = domain.spec().tau();
        drift = n == 1 ? 0 : (1 - tau) / (n - 1);
        left = new double[n];
        posterior = new double[n];
        double gamma = domain.discount();
        start = turn(domain.task(scene));
        pickPrice = new double[n];
        double repeated = 0;
        for (int i = 0; i < n; i++) {
            int pick = scene.model(Act.of(PickType.VERB, scene.objects().get(i).name())).index();
            pickPrice[i] = start.task.effect(pick).reward() * PickPrice.prices(domain.pickRule(), gamma);
            if (asks[0] != null) {
                Question once = question(start, i);
                repeated = Math.max(repeated, question(once.next, i).reward - once.reward);
            }
        }
        mostRepeated = repeated;
        wrongEnds = domain.spec().wrongPick() == WrongPick.TERMINAL;
        lastDiscount = PickPrice.outcome(domain.pickRule(), gamma);
    }

    private Turn turn(Task task) {
        return turns.computeIfAbsent(task, t -> new Turn(t, new Question[n]));
    }

    private Question question(Turn turn, int x) {
        Question question = turn.questions[x];
        if (question == null) {
            ActEffect effect = turn.task.effect(asks[x].index());
            question = new Question(effect.reward(), turn.task.expectedAnswers(asks[x].index()).yes(), turn(effect.during()));
            turn.questions[x] = question;
        }
        return question;
    }

    /** The act that asks about an object; -1 if there are no questions. */
    int act(int object) {
        return asks[object] == null ? -1 : asks[object].index();
    }

    /** What it costs, or pays, that the first question is asked in {@code task} and not with nothing open. */
    double repeating(Task task, int likeliest) {
        return asks[0] == null ? 0
                : task.effect(asks[likeliest].index()).reward() - question(start, likeliest).reward;
    }

    /** Upper bound of {@link #repeating}. */
    double mostRepeated() {
        return mostRepeated;
    }

    /**
     * The value at a belief with nothing open; minus infinity if there are no questions to ask.
     *
     * @param b not modified
     * @param likeliest in b
     * @param otherwise what it is worth to have handed over the wrong object or to have no answer to anything
     * @param afterHandover what it is worth to have handed over the right one
     */
    double value(double[] b, int likeliest, double otherwise, double afterHandover) {
        if (asks[0] == null) {
            return Double.NEGATIVE_INFINITY;
        }
        System.arraycopy(b, 0, left, 0, n);
        double afterRight = lastDiscount * (domain.pickReward(true) + domain.discount() * afterHandover);
        double afterWrong = lastDiscount * (domain.pickReward(false) + (wrongEnds ? 0 : domain.discount() * otherwise));
        Turn turn = start;
        double value = 0;
        double discount = 1;
        double mass = 1;
        int x = likeliest;
        int most = Math.min(2 * n, MOST_QUESTIONS);
        for (int k = 0; k < most && mass > NEGLIGIBLE; k++) {
            Question question = question(turn, x);
            move(mass);
            value += discount * mass * (question.reward + domain.matchReward(posterior, human[x], n));
            double[] yes = question.yes;
            double right = left[x] * yes[x];
            double yesMass = 0;
            int next = 0;
            double largest = -1;
            for (int i = 0; i < n; i++) {
                double y = left[i] * yes[i];
                double l = left[i] - y;
                yesMass += y;
                left[i] = l;
                next = l > largest ? i : next;
                largest = l > largest ? l : largest;
            }
            right = tau * right + drift * (yesMass - right);
            discount *= domain.discount();
            value += discount * (yesMass * pickPrice[x] + right * afterRight + (yesMass - right) * afterWrong);
            mass -= yesMass;
            turn = question.next;
            x = next;
        }
        return value + discount * mass * otherwise;
    }

    /** Fills in b on the path, a step later; the wish may move. */
    private void move(double mass) {
        double scale = 1 / mass;
        for (int i = 0; i < n; i++) {
            posterior[i] = left[i] * scale;
        }
        if (tau < 1) {
            Simplex.propagate(tau, posterior, posterior, n);
            for (int i = 0; i < n; i++) {
                left[i] = posterior[i] * mass;
            }
        }
    }
}
