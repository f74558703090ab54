package handover.solver;

import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.WrongPick;
import handover.math.Simplex;
import java.util.Arrays;

/**
 * What leaves are worth: the best of four simple policies that can be executed. Hand over the likeliest object now, and go on
 * after a wrong one; wait for ever; {@link AskInTurn}; or, where a pick takes increments, {@link ReachInTurn}. The first two
 * observe nothing, so that their value is a lower bound on that of any good policy (where the wish stands still, tau = 1;
 * otherwise what happens after a wrong object is rounded); the others are bounds up to their match part. What does not change
 * among the acts of a belief is computed once for it, and what cannot beat the others is not computed at all. Used by one thread at
 * a time.
 */
final class CommitOrWait {
    /** After so many wrong objects in a row the rest of the value is that of waiting. */
    private static final int MOST_PICKS = 3;

    private final HandoverDomain domain;
    private final AskInTurn asking;
    private final ReachInTurn reaching;
    private final UpperBounds bounds;
    /** Whether a pick is one increment, to which nobody objects. */
    private final boolean atOnce;
    private final int n;
    private final double[] uniform;
    /** By object, the act that reaches for it. */
    private final int[] picks;
    private final double waitReward;
    /** Of knowing nothing and waiting. */
    private final double unanswered;
    /** By how many more objects may be handed over after one: what the table that is left is worth. */
    private final double[] afterHandover;
    private final double[][] rest;
    private final double[] human;
    private final double[] otherHuman;
    private final double[] wish;
    private final double perIncrement;
    private final double tries;
    private final double onAdvance;

    CommitOrWait(Scene scene) {
        this.domain = scene.domain();
        this.n = scene.size();
        this.uniform = Simplex.uniform(n);
        this.picks = new int[n];
        scene.acts().stream().filter(ActModel::isPick).forEach(m -> picks[m.target()] = m.index());
        Task start = domain.task(scene);
        this.waitReward = start.effect(Act.WAIT).reward();
        this.unanswered = waiting(domain.matchReward(uniform, uniform, n));
        this.asking = new AskInTurn(scene);
        this.atOnce = domain.pickRule().increments() == 1;
        this.reaching = new ReachInTurn(scene, asking, picks, unanswered);
        this.afterHandover = afterHandovers();
        this.rest = new double[MOST_PICKS][n];
        this.human = new double[n];
        this.otherHuman = new double[n];
        this.wish = new double[n];
        this.bounds = new UpperBounds(scene, picks, MOST_PICKS, this::waiting, Arrays.stream(afterHandover).max().orElseThrow());
        double gamma = domain.discount();
        this.perIncrement = domain.pickRule().perIncrement(gamma);
        this.tries = domain.pickRule().tries(gamma);
        this.onAdvance = domain.pickRule().onAdvance(gamma);
    }

    /** The best of waiting, asking and reaching in turn for a new wish, as if the table were this one. */
    private double[] afterHandovers() {
        double[] value = new double[Math.min(domain.spec().handovers(), n)];
        for (int left = 1; left < value.length; left++) {
            double[] fresh = Simplex.uniform(n - 1);
            double act = Math.max(asking.value(uniform, 0, unanswered, value[left - 1]),
                    atOnce ? Double.NEGATIVE_INFINITY : reaching.value(uniform, 0, value[left - 1]));
            value[left] = Math.max(waiting(domain.matchReward(fresh, fresh, n - 1)), act);
        }
        return value;
    }

    /** What is left to earn once the object that is wanted is handed over. */
    private double afterHandover(Task task) {
        return afterHandover[Math.max(0, Math.min(afterHandover.length, domain.spec().handovers() - task.handovers()) - 1)];
    }

    UpperBounds bounds() {
        return bounds;
    }

    /** By object, the act that reaches for it; not to be modified. */
    int[] picks() {
        return picks;
    }

    /**
     * Where a pick takes increments: reaches for the likeliest object and listens, and completes the pick if that is better than
     * asking in turn; if not, asks. -1 where a pick is one increment.
     */
    int simple(HandoverSearch.Node node) {
        if (atOnce) {
            return -1;
        }
        SearchBelief b = node.b;
        int x = b.likeliest();
        ActEffect pick = node.task.effect(picks[x]);
        int ask = asking.act(x);
        boolean complete = !pick.completes() || ask < 0 || domain.expectedPickReward(b.p[x]) + domain.discount() * b.p[x] * afterHandover(node.task) > asking(node);
        return complete ? picks[x] : ask;
    }

    /** The value of a belief at which no pick has just completed. */
    double value(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        double best = Math.max(reaching(node), asking(node) + asking.repeating(node.task, b.likeliest()));
        if (waiting(node.match) > best) {
            best = Math.max(best, waiting(Math.min(node.match, matchUniform(b))));
        }
        if (domain.spec().tau() < 1 || commitBound(node) > best) {
            best = Math.max(best, committing(node, b.likeliest()));
        }
        if (node.task.target() != null) {
            int x = node.task.scene().indexOf(node.task.target());
            if (domain.spec().tau() < 1 || bounds.reaching(b, x) > best) {
                best = Math.max(best, committing(node, x));
            }
            if (x == b.likeliest()) {
                best = Math.max(best, reaching.value(b.p, node.task, x, afterHandover(node.task)));
            }
        }
        return best;
    }

    /** The value of what follows a completed pick, before its outcome is known. */
    double afterPick(HandoverSearch.Node predicted) {
        int x = predicted.effect.model().target();
        double right = predicted.b.p[x];
        return later(right, predicted.task, right < 1 ? afterRejection(predicted.b, x, predicted.task) : 0);
    }

    /**
     * Waiting for ever. The human's belief then goes straight towards uniform and every score is concave in it, so that
     * the worse of the two ends bounds the match part from below.
     */
    private double waiting(double match) {
        return (waitReward + match) / (1 - domain.discount());
    }

    /** The value of asking in turn when nothing is open. */
    private double asking(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        if (Double.isNaN(b.asking)) {
            b.asking = asking.value(b.p, b.likeliest(), unanswered, afterHandover(node.task));
        }
        return b.asking;
    }

    /** The value of reaching in turn when nothing is reached for. */
    private double reaching(HandoverSearch.Node node) {
        if (atOnce) {
            return Double.NEGATIVE_INFINITY;
        }
        SearchBelief b = node.b;
        if (Double.isNaN(b.reaching)) {
            b.reaching = reaching.value(b.p, b.likeliest(), afterHandover(node.task));
        }
        return b.reaching;
    }

    private double matchUniform(SearchBelief b) {
        if (Double.isNaN(b.matchUniform)) {
            b.matchUniform = domain.matchReward(b.p, uniform, n);
        }
        return b.matchUniform;
    }

    private double committing(HandoverSearch.Node node, int x) {
        double right = node.b.p[x];
        double afterRejection = right < 1 ? afterRejection(node.b, x, node.task.effect(picks[x]).during()) : 0;
        return committing(node.b.p, node.h, node.task, x, afterRejection);
    }

    /** Reaching for object {@code x} until the pick completes, and going on from there. */
    private double committing(double[] b, double[] h, Task from, int x, double afterRejection) {
        double value = 0;
        double discount = 1;
        Task task = from;
        double[] expected = h;
        double[] wanted = b;
        while (true) {
            ActEffect effect = task.effect(picks[x]);
            double[] next = expected == human ? otherHuman : human;
            domain.understand(effect.model(), expected, next, n);
            wanted = moved(wanted);
            value += discount * tries * (effect.reward() + domain.matchReward(wanted, next, n));
            task = effect.during();
            expected = next;
            if (effect.completes()) {
                return value + discount * onAdvance * (domain.expectedPickReward(wanted[x])
                        + domain.discount() * later(wanted[x], task, afterRejection));
            }
            discount *= perIncrement;
        }
    }

    /** b a step later. */
    private double[] moved(double[] b) {
        double tau = domain.spec().tau();
        if (tau == 1) {
            return b;
        }
        Simplex.propagate(tau, b, wish, n);
        return wish;
    }

    private double later(double right, Task during, double afterRejection) {
        return right * afterHandover(during)
                + (1 - right) * (during.completed(false).done() ? 0 : afterRejection);
    }

    private double afterRejection(SearchBelief b, int x, Task picking) {
        if (b.rejected != x) {
            b.rejected = x;
            b.afterRejection = afterRejection(b.p, x, picking.completed(false), 0);
        }
        return b.afterRejection;
    }

    /**
     * The value once {@code x} turned out not to be wanted, for a human who expects nothing in particular; where it left
     * the table, that of waiting.
     */
    private double afterRejection(double[] b, int x, Task task, int picked) {
        double[] p = rest[picked];
        System.arraycopy(b, 0, p, 0, n);
        p[x] = 0;
        if (!(Simplex.normalise(p, n) > 0)) {
            return unanswered;
        }
        double wait = waiting(domain.matchReward(p, uniform, n));
        if (picked == MOST_PICKS - 1 || task.done() || domain.spec().wrongPick() == WrongPick.REMOVED) {
            return task.done() ? 0 : wait;
        }
        int y = Simplex.argmax(p, n);
        double later = p[y] < 1 ? afterRejection(p, y, task, picked + 1) : 0;
        return Math.max(wait, committing(p, uniform, task, y, later));
    }

    /** On {@link #value} after an act that is no pick. */
    double bound(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        return Math.max(Math.max(reaching(node), asking(node) + asking.mostRepeated()), Math.max(waiting(bounds.match(b)), commitBound(node)));
    }

    /** On handing over the likeliest object now; as tight as it needs to be to tell whether that can beat asking. */
    private double commitBound(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        if (Double.isNaN(b.commitBound)) {
            int x = b.likeliest();
            double right = b.p[x];
            b.commitBound = bounds.pick(b, bounds.outcome(right));
            if (b.commitBound > asking(node)) {
                Task picking = node.task.effect(picks[x]).during();
                double afterRejection = right < 1 ? afterRejection(b, x, picking) : 0;
                b.commitBound = bounds.pick(b, domain.expectedPickReward(right)
                        + domain.discount() * later(right, picking, afterRejection));
            }
        }
        return b.commitBound;
    }
}
