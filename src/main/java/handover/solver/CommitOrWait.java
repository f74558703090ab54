package handover.solver;

import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.WrongPick;
import handover.math.Simplex;

/**
 * The value of the simplest policy that can be executed: hand over the likeliest object now, or wait for ever, whichever is
 * worth more; after a wrong object the same again. It observes nothing, so that (with a target that stands still, tau = 1)
 * its value is a lower bound on that of any good policy. Used by one thread at a time.
 */
final class CommitOrWait {
    /** After so many wrong objects in a row the rest of the value is that of waiting. */
    private static final int MOST_PICKS = 3;

    private final HandoverSearch search;
    private final HandoverDomain domain;
    private final double[] uniform;
    private final int[] picks;
    private final double waitReward;
    private final double afterHandover;
    private final double[][] rest;
    private final double[] human;
    private final Task start;

    CommitOrWait(HandoverSearch search, Scene scene) {
        this.search = search;
        this.domain = scene.domain();
        int n = scene.size();
        this.uniform = Simplex.uniform(n);
        this.picks = new int[n];
        scene.acts().stream().filter(m -> m.isPick()).forEach(m -> picks[m.target()] = m.index());
        this.waitReward = scene.model(Act.WAIT).type().parameters().reward();
        this.afterHandover = n == 1 ? 0 : waiting(Simplex.uniform(n - 1), Simplex.uniform(n - 1), Simplex.uniform(n - 1));
        this.rest = new double[MOST_PICKS][n];
        this.human = new double[n];
        this.start = domain.task(scene);
    }

    /** What the human expects when a wish is new. */
    double[] uniform() {
        return uniform;
    }

    double value(HandoverSearch.Node node) {
        HandoverSearch.Belief b = node.b;
        int likeliest = b.likeliest();
        double best = Math.max(waiting(b.p, node.h, uniform), committing(node, likeliest));
        if (node.task.target() != null) {
            int target = node.task.scene().indexOf(node.task.target());
            best = target == likeliest ? best : Math.max(best, committing(node, target));
        }
        return best;
    }

    /**
     * Waiting for ever. The human's belief then goes straight towards uniform and every score is concave in it, so that
     * the worse of the two ends bounds the match part from below.
     */
    private double waiting(double[] b, double[] h, double[] towards) {
        int n = towards.length;
        double match = Math.min(domain.matchReward(b, h, n), domain.matchReward(b, towards, n));
        return (waitReward + match) / (1 - domain.discount());
    }

    private double committing(HandoverSearch.Node node, int x) {
        HandoverSearch.Belief b = node.b;
        if (b.rejected != x && b.p[x] < 1) {
            b.rejected = x;
            b.afterRejection = afterWrong(b.p, x, 0);
        }
        return committing(b.p, node.h, node.task, x, b.afterRejection);
    }

    /** Reaching for object {@code x} until the pick completes, and going on from there. */
    private double committing(double[] b, double[] h, Task from, int x, double afterWrong) {
        double value = 0;
        double discount = 1;
        Task task = from;
        double[] expected = h;
        while (true) {
            ActEffect effect = task.effect(picks[x]);
            domain.understand(effect.model(), expected, human, uniform.length);
            value += discount * search.reward(effect, b, human, uniform.length);
            discount *= domain.discount();
            task = effect.during();
            expected = human;
            if (effect.completes()) {
                double right = task.completed(true).done() ? 0 : b[x] * afterHandover;
                double wrong = task.completed(false).done() ? 0 : (1 - b[x]) * afterWrong;
                return value + discount * (right + wrong);
            }
        }
    }

    /**
     * The value once {@code x} turned out not to be wanted, for a human who expects nothing in particular; where it left
     * the table, that of waiting.
     */
    private double afterWrong(double[] b, int x, int picked) {
        double[] p = rest[picked];
        System.arraycopy(b, 0, p, 0, p.length);
        p[x] = 0;
        if (!(Simplex.normalise(p, p.length) > 0)) {
            return waiting(uniform, uniform, uniform);
        }
        double wait = waiting(p, uniform, uniform);
        if (picked == MOST_PICKS - 1 || domain.spec().wrongPick() == WrongPick.REMOVED) {
            return wait;
        }
        int y = Simplex.argmax(p, p.length);
        double later = p[y] < 1 ? afterWrong(p, y, picked + 1) : 0;
        return Math.max(wait, committing(p, uniform, start, y, later));
    }
}
