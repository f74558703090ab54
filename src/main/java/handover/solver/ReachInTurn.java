package handover.solver;

import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.WrongPick;
import handover.math.Simplex;

/**
 * The value of a policy that reaches for the likeliest object, increment by increment, until somebody says no: then for the
 * next one, or it asks in turn. It listens to nothing else. Its match part is that of a human who expects nothing in
 * particular before the first increment; who says no while an increment stalls is not followed (approximate). Used by one
 * thread at a time.
 */
final class ReachInTurn {
    /** After so many objections in a row it only asks. */
    private static final int MOST_OBJECTIONS = 2;

    private final HandoverDomain domain;
    private final AskInTurn asking;
    private final int n;
    private final int[] picks;
    /** By object, then increment: what a human expects who expected nothing in particular. */
    private final double[][][] human;
    private final Task start;
    private final double unanswered;
    private final double tries;
    private final double perIncrement;
    private final double onAdvance;
    /** By objections: the belief on the path, and that of who objects to it. */
    private final double[][] path;
    private final double[][] objecting;

    /**
     * @param picks by object, the act that reaches for it
     * @param unanswered the value of knowing nothing and waiting
     */
    ReachInTurn(Scene scene, AskInTurn asking, int[] picks, double unanswered) {
        this.domain = scene.domain();
        this.asking = asking;
        this.picks = picks;
        this.unanswered = unanswered;
        n = scene.size();
        start = domain.task(scene);
        int increments = domain.pickRule().increments();
        human = new double[n][increments][];
        for (int x = 0; x < n; x++) {
            double[] h = Simplex.uniform(n);
            for (int k = 0; k < increments; k++) {
                h = domain.understood(scene.acts().get(picks[x]), h);
                human[x][k] = h;
            }
        }
        double gamma = domain.discount();
        tries = domain.pickRule().tries(gamma);
        perIncrement = domain.pickRule().perIncrement(gamma);
        onAdvance = domain.pickRule().onAdvance(gamma);
        path = new double[MOST_OBJECTIONS + 1][n];
        objecting = new double[MOST_OBJECTIONS + 1][n];
    }

    /**
     * The value at a belief at which nothing is reached for.
     *
     * @param afterHandover what it is worth to have handed over what is wanted
     */
    double value(double[] b, int likeliest, double afterHandover) {
        return value(b, start, likeliest, afterHandover, 0);
    }

    /**
     * The value of going on to reach for object {@code x}.
     *
     * @param b not modified
     * @param from the task, in which something may have been done of it
     */
    double value(double[] b, Task from, int x, double afterHandover) {
        return value(b, from, x, afterHandover, 0);
    }

    private double value(double[] b, Task from, int x, double afterHandover, int objections) {
        double[] p = path[objections];
        System.arraycopy(b, 0, p, 0, n);
        Task task = from;
        double value = 0;
        double weight = 1;
        while (true) {
            ActEffect effect = task.effect(picks[x]);
            Simplex.propagate(domain.spec().tau(), p, p, n);
            int k = effect.completes() ? human[x].length - 1 : effect.during().progress() - 1;
            value += weight * tries * (effect.reward() + domain.matchReward(p, human[x][k], n));
            if (effect.completes()) {
                return value + weight * onAdvance * outcome(p, x, effect.during(), afterHandover, objections);
            }
            double[] no = task.expectedAnswers(picks[x]).no();
            double objects = 0;
            double[] q = objecting[objections];
            for (int i = 0; i < n; i++) {
                q[i] = p[i] * no[i];
                objects += q[i];
                p[i] -= q[i];
            }
            weight *= perIncrement;
            if (objects > 0) {
                value += weight * objects * afterObjection(q, afterHandover, objections);
            }
            if (!(Simplex.normalise(p, n) > 0)) {
                return value;
            }
            weight *= 1 - objects;
            task = effect.during();
        }
    }

    private double afterObjection(double[] q, double afterHandover, int objections) {
        Simplex.normalise(q, n);
        int next = Simplex.argmax(q, n);
        double ask = asking.value(q, next, unanswered, afterHandover);
        return objections == MOST_OBJECTIONS - 1 ? Math.max(ask, unanswered)
                : Math.max(ask, value(q, start, next, afterHandover, objections + 1));
    }

    /** Of a completed pick, and what follows. */
    private double outcome(double[] p, int x, Task during, double afterHandover, int objections) {
        double right = p[x];
        double now = domain.expectedPickReward(right) + domain.discount() * right * afterHandover;
        if (right >= 1 || during.completed(false).done()) {
            return now;
        }
        double[] q = objecting[objections];
        System.arraycopy(p, 0, q, 0, n);
        q[x] = 0;
        Simplex.normalise(q, n);
        double again = domain.spec().wrongPick() == WrongPick.REMOVED ? unanswered
                : Math.max(unanswered, asking.value(q, Simplex.argmax(q, n), unanswered, afterHandover));
        return now + domain.discount() * (1 - right) * again;
    }
}
