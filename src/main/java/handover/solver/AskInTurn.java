package handover.solver;

import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.AskType;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.domain.Scene;
import handover.domain.Task;
import handover.math.Simplex;

/**
 * The value of a policy that asks about one object after the other, the likeliest first, hands over the first that gets a
 * yes, and listens to nothing else. It is followed in expectation along the one path on which nobody says yes. Its match
 * part, which is small, is that of a human who expects nothing in particular before each question, and 0 for the pick that
 * follows a yes. Used by one thread at a time.
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
    /** What reaching for each object comes to. */
    private final double[] pickPrice;
    private final double lastDiscount;
    /** Nothing is open yet. */
    private final Task start;
    private final double mostRepeated;

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
        left = new double[n];
        posterior = new double[n];
        double gamma = domain.discount();
        start = domain.task(scene);
        pickPrice = new double[n];
        double repeated = 0;
        for (int i = 0; i < n; i++) {
            double price = start.effect(scene.model(Act.of(PickType.VERB, scene.objects().get(i).name())).index()).reward();
            pickPrice[i] = price * PickPrice.prices(domain.pickRule(), gamma);
            if (asks[0] != null) {
                ActEffect once = start.effect(asks[i].index());
                repeated = Math.max(repeated, once.during().effect(asks[i].index()).reward() - once.reward());
            }
        }
        mostRepeated = repeated;
        lastDiscount = PickPrice.outcome(domain.pickRule(), gamma);
    }

    /** What it costs, or pays, that the first question is asked in {@code task} and not with nothing open. */
    double repeating(Task task, int likeliest) {
        return asks[0] == null ? 0
                : task.effect(asks[likeliest].index()).reward() - start.effect(asks[likeliest].index()).reward();
    }

    /** Upper bound of {@link #repeating}. */
    double mostRepeated() {
        return mostRepeated;
    }

    /**
     * The value at a belief with nothing open; minus infinity if there are no questions to ask.
     *
     * @param b not modified
     * @param otherwise what it is worth to have handed over the wrong object or to have no answer to anything
     */
    double value(double[] b, double otherwise) {
        if (asks[0] == null) {
            return Double.NEGATIVE_INFINITY;
        }
        System.arraycopy(b, 0, left, 0, n);
        double afterWrong = domain.pickReward(false) + domain.discount() * otherwise;
        Task task = start;
        double value = 0;
        double discount = 1;
        double mass = 1;
        for (int k = 0; k < Math.min(2 * n, MOST_QUESTIONS) && mass > NEGLIGIBLE; k++) {
            int x = Simplex.argmax(left, n);
            ActEffect effect = task.effect(asks[x].index());
            double[] yes = effect.answers().yes();
            move(mass);
            double right = left[x] * yes[x];
            double yesMass = 0;
            for (int i = 0; i < n; i++) {
                double y = left[i] * yes[i];
                yesMass += y;
                left[i] -= y;
            }
            value += discount * mass * (effect.reward() + domain.matchReward(posterior, human[x], n));
            right = tau * right + (n == 1 ? 0 : (1 - tau) / (n - 1)) * (yesMass - right);
            discount *= domain.discount();
            value += discount * (yesMass * pickPrice[x]
                    + lastDiscount * (right * domain.pickReward(true) + (yesMass - right) * afterWrong));
            mass -= yesMass;
            task = effect.during();
        }
        return value + discount * mass * otherwise;
    }

    /** Fills in b on the path, a step later; the wish may move. */
    private void move(double mass) {
        for (int i = 0; i < n; i++) {
            posterior[i] = left[i] / mass;
        }
        if (tau < 1) {
            Simplex.propagate(tau, posterior, posterior, n);
            for (int i = 0; i < n; i++) {
                left[i] = posterior[i] * mass;
            }
        }
    }
}
