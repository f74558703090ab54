package handover.solver;

import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Task;
import handover.math.Simplex;

/**
 * What it is worth to be told before every act what the human wants: to reach for it, with all increments, until it is handed
 * over, and so on for every handover that is left; or, if nothing is worth that, to wait for ever. Where the wish may move
 * (tau &lt; 1) the robot follows it. Later tables are taken to be worth what this one is, and an increment that stalls to tell
 * the human what one that advances tells them. Immutable, thread safe.
 */
final class KnownWish {
    private static final double PRECISE = 1e-9;

    private final HandoverDomain domain;
    private final int n;
    private final double tau;
    private final double gamma;
    private final double advance;
    /** By object: b after a step before which it was wanted. */
    private final double[][] wish;
    private final int[] picks;
    private final double[] waiting;
    /** By handovers that are left: the mean value of a wish that is new; 0 for none left. */
    private final double[] fresh;

    KnownWish(Scene scene) {
        domain = scene.domain();
        n = scene.size();
        tau = n == 1 ? 1 : domain.spec().tau();
        gamma = domain.discount();
        advance = domain.pickRule().advance();
        picks = new int[n];
        scene.acts().stream().filter(ActModel::isPick).forEach(m -> picks[m.target()] = m.index());
        wish = new double[n][];
        waiting = new double[n];
        Task start = domain.task(scene);
        double[] uniform = Simplex.uniform(n);
        double wait = start.effect(Act.WAIT).reward();
        for (int i = 0; i < n; i++) {
            wish[i] = Simplex.vertex(n, i);
            Simplex.propagate(tau, wish[i], wish[i], n);
            waiting[i] = (wait + domain.matchReward(wish[i], uniform, n)) / (1 - gamma);
        }
        fresh = new double[1 + Math.min(n, domain.spec().handovers())];
        for (int left = 1; left < fresh.length; left++) {
            settle(left, start, uniform);
        }
    }

    /** A wish that may move is worth what depends on what a new wish is worth. */
    private void settle(int left, Task start, double[] uniform) {
        Path path = path();
        double before;
        do {
            before = fresh[left];
            double sum = 0;
            for (int i = 0; i < n; i++) {
                sum += path.value(i, start, uniform, left);
            }
            fresh[left] = sum / n;
        } while (Math.abs(fresh[left] - before) > PRECISE);
    }

    /** The value once a pick completed: of the next wish, or of one of the others. */
    double afterPick(Task completed) {
        return completed.done() ? 0 : fresh[left(completed)];
    }

    private int left(Task task) {
        return Math.min(fresh.length - 1, domain.spec().handovers() - task.handovers());
    }

    Path path() {
        return new Path();
    }

    /** Values, with the arrays to compute them. Used by one thread at a time. */
    final class Path {
        private final double[] rewards = new double[domain.pickRule().increments()];
        private final double[] human = new double[n];
        private final double[] otherHuman = new double[n];

        /** The value of a task of this scene at which object {@code i} is wanted and the human believes {@code h} (not modified). */
        double value(int i, Task task, double[] h) {
            return value(i, task, h, left(task));
        }

        private double value(int i, Task task, double[] h, int left) {
            return Math.max(waiting[i], reaching(i, task, h, left));
        }

        /** Forward along the increments for what people come to believe, then backward for what it is worth. */
        private double reaching(int i, Task from, double[] h, int left) {
            double[] expected = h;
            Task task = from;
            int increments = 0;
            ActEffect effect;
            do {
                effect = task.effect(picks[i]);
                double[] next = expected == human ? otherHuman : human;
                domain.understand(effect.model(), expected, next, n);
                rewards[increments++] = effect.reward() + domain.matchReward(wish[i], next, n);
                expected = next;
                task = effect.during();
            } while (!effect.completes());
            double elsewhere = (1 - tau) * fresh[left];
            double stalls = gamma * (1 - advance);
            double onward = completion(task, left);
            double value = 0;
            for (int k = increments - 1; k >= 0; k--) {
                value = (rewards[k] + advance * onward + stalls * elsewhere) / (1 - stalls * tau);
                onward = gamma * (tau * value + elsewhere);
            }
            return value;
        }

        private double completion(Task during, int left) {
            double right = domain.pickReward(true) + gamma * (during.completed(true).done() ? 0 : fresh[left - 1]);
            double wrong = domain.pickReward(false) + gamma * (during.completed(false).done() ? 0 : fresh[left]);
            return tau * right + (1 - tau) * wrong;
        }
    }
}
