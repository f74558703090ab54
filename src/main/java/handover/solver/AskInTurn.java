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
 * yes, and listens to nothing else. Followed in expectation along the one path on which nobody says yes, for a human who
 * expects nothing in particular. Used by one thread at a time.
 */
final class AskInTurn {
    private static final double NEGLIGIBLE = 1e-3;

    private final HandoverDomain domain;
    private final int n;
    private final ActModel[] asks;
    private final double[] left;
    private final double[] posterior;
    private final double[] human;
    private final double pickPrice;
    private final double lastDiscount;

    AskInTurn(Scene scene) {
        domain = scene.domain();
        n = scene.size();
        asks = new ActModel[n];
        for (int i = 0; i < n; i++) {
            asks[i] = scene.model(Act.of(AskType.VERB, scene.objects().get(i).name()));
        }
        left = new double[n];
        posterior = new double[n];
        human = new double[n];
        double gamma = domain.discount();
        double increment = scene.model(Act.of(PickType.VERB, scene.objects().get(0).name())).type().parameters().reward();
        pickPrice = increment * (1 - Math.pow(gamma, domain.increments())) / (1 - gamma);
        lastDiscount = Math.pow(gamma, domain.increments() - 1);
    }

    /**
     * The value at a belief; minus infinity if there are no questions to ask.
     *
     * @param b not modified
     * @param otherwise what it is worth to have handed over the wrong object or to have no answer to anything
     */
    double value(double[] b, Task from, double otherwise) {
        if (asks[0] == null) {
            return Double.NEGATIVE_INFINITY;
        }
        System.arraycopy(b, 0, left, 0, n);
        java.util.Arrays.fill(human, 1.0 / n);
        Task task = from;
        double value = 0;
        double discount = 1;
        double mass = 1;
        for (int k = 0; k < 2 * n && mass > NEGLIGIBLE; k++) {
            int x = Simplex.argmax(left, n);
            ActEffect effect = task.effect(asks[x].index());
            domain.understand(effect.model(), human, human, n);
            for (int i = 0; i < n; i++) {
                posterior[i] = left[i] / mass;
            }
            value += discount * mass * (effect.reward() + domain.matchReward(posterior, human, n));
            double right = left[x] * effect.yes()[x];
            double yes = 0;
            for (int i = 0; i < n; i++) {
                double y = left[i] * effect.yes()[i];
                yes += y;
                left[i] -= y;
            }
            discount *= domain.discount();
            value += discount * (yes * pickPrice + lastDiscount * (right * domain.pickReward(true)
                    + (yes - right) * (domain.pickReward(false) + domain.discount() * otherwise)));
            mass -= yes;
            task = effect.during();
        }
        return value + discount * mass * otherwise;
    }
}
