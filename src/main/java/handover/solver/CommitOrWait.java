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
import java.util.stream.IntStream;

/**
 * What leaves are worth: the best of four simple policies that can be executed. Hand over the likeliest object now, and go on
 * after a wrong one; wait for ever; {@link AskInTurn}; or, where a pick takes increments, {@link ReachInTurn}. The first two
 * observe nothing, so that their value is a lower bound on that of any good policy (where the wish stands still, tau = 1;
 * otherwise what happens after a wrong object is rounded); the others are bounds up to their match part. What does not change among the acts of a belief is computed once for it, and
 * what cannot beat the others is not computed at all. Used by one thread at a time.
 */
final class CommitOrWait {
    /** After so many wrong objects in a row the rest of the value is that of waiting. */
    private static final int MOST_PICKS = 3;
    /** Keeps bounds above values that were added up in another order. */
    private static final double ROUNDING = 1e-9;

    private final HandoverSearch search;
    private final HandoverDomain domain;
    private final AskInTurn asking;
    private final ReachInTurn reaching;
    /** Whether a pick is one increment, to which nobody objects. */
    private final boolean atOnce;
    private final Evidence evidence;
    private final int n;
    private final double[] uniform;
    /** By object, the act that reaches for it. */
    private final int[] picks;
    private final int[] allPicks;
    private final double waitReward;
    /** Of knowing nothing and waiting. */
    private final double unanswered;
    private final double afterHandover;
    private final double[][] rest;
    private final double[] human;
    private final double[] otherHuman;
    private final double[] wish;
    /** At most paid for all increments of a pick, without their match reward. */
    private final double pricePerPick;
    /** Expected discounted number of increments of a pick. */
    private final double increments;
    /** The best match reward at any belief. */
    private final double matchBound;
    /** At most earned by any acts from some belief on, and after an object was handed over. */
    private final double most;
    private final double mostAfterHandover;
    private final double boundOfRightPick;
    private final double boundOfWrongPick;
    /** The discount of a pick's outcome. */
    private final double lastDiscount;
    private final double perIncrement;
    private final double tries;
    private final double onAdvance;

    CommitOrWait(HandoverSearch search, Scene scene, Evidence evidence) {
        this.evidence = evidence;
        this.search = search;
        this.domain = scene.domain();
        this.n = scene.size();
        this.uniform = Simplex.uniform(n);
        this.picks = new int[n];
        scene.acts().stream().filter(ActModel::isPick).forEach(m -> picks[m.target()] = m.index());
        this.allPicks = scene.acts().stream().filter(ActModel::isPick).mapToInt(ActModel::index).toArray();
        Task start = domain.task(scene);
        this.waitReward = start.effect(Act.WAIT).reward();
        this.unanswered = waiting(domain.matchReward(uniform, uniform, n));
        this.asking = new AskInTurn(scene);
        this.atOnce = domain.pickRule().increments() == 1;
        this.reaching = new ReachInTurn(scene, asking, picks, unanswered);
        double[] fresh = Simplex.uniform(n - 1);
        this.afterHandover = n == 1 ? 0 : waiting(domain.matchReward(fresh, fresh, n - 1));
        this.rest = new double[MOST_PICKS][n];
        this.human = new double[n];
        this.otherHuman = new double[n];
        this.wish = new double[n];
        double gamma = domain.discount();
        double price = Arrays.stream(picks).mapToDouble(k -> start.effect(k).reward()).max().orElseThrow();
        this.increments = PickPrice.prices(domain.pickRule(), gamma);
        this.pricePerPick = price * increments;
        this.matchBound = IntStream.range(0, n).mapToDouble(i -> domain.matchBound(Simplex.vertex(n, i), n)).max().orElseThrow();
        this.lastDiscount = PickPrice.outcome(domain.pickRule(), gamma);
        double act = scene.acts().stream().mapToDouble(m -> start.effect(m.index()).reward()).max().orElseThrow();
        double steps = Math.max(0, matchBound + act + Math.max(0, domain.spec().rewards().annoyance())) / (1 - gamma);
        double handover = Math.max(0, domain.pickReward(true));
        this.most = domain.pickReward(false) > 0 ? Double.POSITIVE_INFINITY : steps + domain.spec().handovers() * handover;
        this.mostAfterHandover = domain.spec().handovers() == 1 ? 0 : most - handover;
        this.boundOfRightPick = domain.pickReward(true) + gamma * Math.max(0, afterHandover);
        double perPick = Math.max(0, increments * (price + matchBound));
        double best = Math.max(0, waiting(matchBound));
        for (int k = 0; k < MOST_PICKS; k++) {
            best = Math.max(best, perPick + Math.max(Math.max(0, boundOfRightPick), domain.pickReward(false) + gamma * best));
        }
        this.boundOfWrongPick = domain.pickReward(false) + gamma * best;
        this.perIncrement = domain.pickRule().perIncrement(gamma);
        this.tries = domain.pickRule().tries(gamma);
        this.onAdvance = domain.pickRule().onAdvance(gamma);
    }

    /** Gestures at this table. */
    Evidence evidence() {
        return evidence;
    }

    /** What the human expects when a wish is new. */
    double[] uniform() {
        return uniform;
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
        boolean complete = !pick.completes() || ask < 0 || domain.expectedPickReward(b.p[x]) > asking(b);
        return complete ? picks[x] : ask;
    }

    /** The value of a belief at which no pick has just completed. */
    double value(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        double best = Math.max(reaching(b), asking(b) + asking.repeating(node.task, b.likeliest()));
        if (waiting(node.match) > best) {
            best = Math.max(best, waiting(Math.min(node.match, matchUniform(b))));
        }
        if (domain.spec().tau() < 1 || commitBound(node) > best) {
            best = Math.max(best, committing(node, b.likeliest()));
        }
        if (node.task.target() != null) {
            int x = node.task.scene().indexOf(node.task.target());
            if (domain.spec().tau() < 1 || boundOfReaching(b, x) > best) {
                best = Math.max(best, committing(node, x));
            }
            if (x == b.likeliest()) {
                best = Math.max(best, reaching.value(b.p, node.task, x));
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
    private double asking(SearchBelief b) {
        if (Double.isNaN(b.asking)) {
            b.asking = asking.value(b.p, b.likeliest(), unanswered);
        }
        return b.asking;
    }

    /** The value of reaching in turn when nothing is reached for. */
    private double reaching(SearchBelief b) {
        if (atOnce) {
            return Double.NEGATIVE_INFINITY;
        }
        if (Double.isNaN(b.reaching)) {
            b.reaching = reaching.value(b.p, b.likeliest());
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
        return right * (during.completed(true).done() ? 0 : afterHandover)
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

    // ---- upper bounds, by which the search leaves out what cannot be the best -----------------------------------

    /** On the {@link #value} after an act that is no pick. */
    private double boundWithoutPick(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        if (Double.isNaN(b.bound)) {
            b.bound = Math.max(Math.max(reaching(b), asking(b) + asking.mostRepeated()),
                    Math.max(waiting(matchBound(b)), commitBound(node)));
        }
        return b.bound;
    }

    /** On an act, however far the search looks after it. */
    double bound(HandoverSearch.Node node, ActEffect effect) {
        double now = effect.reward() + matchBound(node.b);
        double onward = domain.discount() * most;
        if (!effect.completes()) {
            return now + onward;
        }
        double right = node.b.p[effect.model().target()];
        double outcome = domain.expectedPickReward(right) + right * domain.discount() * mostAfterHandover + (1 - right) * onward;
        return now + effect.advance() * outcome + (1 - effect.advance()) * onward;
    }

    /** On a pick with leaves after it, whether it completes or not. */
    private double boundOfLastPick(HandoverSearch.Node node, int pick) {
        ActEffect effect = node.task.effect(pick);
        double outcome = boundOfOutcome(node.b.p[effect.model().target()]);
        double now = effect.reward() + matchBound(node.b);
        if (effect.completes() && effect.stalled() == null) {
            return now + outcome;
        } else if (effect.model().target() == node.b.likeliest()) {
            return Double.POSITIVE_INFINITY;
        }
        double later = domain.discount() * Math.max(boundOfReaching(node.b, effect.model().target()), boundWithoutPick(node));
        return now + (effect.completes() ? Math.max(outcome, later) : later);
    }

    /** On reaching for an object until the pick completes, whatever was done of it. */
    private double boundOfReaching(SearchBelief b, int x) {
        double outcome = boundOfOutcome(b.p[x]);
        return Math.max(0, pricePerPick + increments * matchBound(b)) + Math.max(outcome, lastDiscount * outcome);
    }

    /** The value of the best act with leaves after it ({@link BeliefMdp#last}). */
    double last(HandoverSearch.Node node, HandoverSearch.Node next) {
        SearchBelief b = node.b;
        double later = domain.discount() * boundWithoutPick(node);
        int likeliest = picks[b.likeliest()];
        double best = boundOfLastPick(node, likeliest) > matchBound(b) + later
                ? value(node, likeliest, next) : Double.NEGATIVE_INFINITY;
        for (int a : node.task.byReward()) {
            ActEffect effect = node.task.effect(a);
            if (effect.reward() + matchBound(b) + later <= best) {
                break;
            }
            double match = domain.matchReward(b.p, node.after(effect.model()), n);
            if (effect.reward() + match + later > best) {
                best = Math.max(best, value(node, a, next));
            }
        }
        for (int a : allPicks) {
            double bound = boundOfLastPick(node, a);
            if (bound > best) {
                best = Math.max(best, valueOfPick(node, a, bound, best, next));
            }
        }
        return best;
    }

    /** The value of an act, or less than {@code best} if its match reward shows that it is not better. */
    private double valueOfPick(HandoverSearch.Node node, int act, double bound, double best, HandoverSearch.Node next) {
        double match = domain.matchReward(node.b.p, node.after(node.task.effect(act).model()), n);
        boolean hopeless = bound - matchBound(node.b) + match + ROUNDING < best;
        return hopeless ? Double.NEGATIVE_INFINITY : value(node, act, next);
    }

    private double value(HandoverSearch.Node node, int act, HandoverSearch.Node next) {
        return search.ending(search.start(node, act, next), true, next);
    }

    private double boundOfOutcome(double right) {
        return right * boundOfRightPick + (1 - right) * boundOfWrongPick;
    }

    private double matchBound(SearchBelief b) {
        if (Double.isNaN(b.matchBound)) {
            b.matchBound = domain.matchBound(b.p, n);
        }
        return b.matchBound;
    }

    /** On handing over the likeliest object now; as tight as it needs to be to tell whether that can beat asking. */
    private double commitBound(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        if (Double.isNaN(b.commitBound)) {
            int x = b.likeliest();
            double right = b.p[x];
            double price = pricePerPick + increments * matchBound(b);
            b.commitBound = price + lastDiscount * boundOfOutcome(right);
            if (b.commitBound > asking(b)) {
                Task picking = node.task.effect(picks[x]).during();
                double afterRejection = right < 1 ? afterRejection(b, x, picking) : 0;
                b.commitBound = price + lastDiscount * (domain.expectedPickReward(right)
                        + domain.discount() * later(right, picking, afterRejection));
            }
        }
        return b.commitBound;
    }
}
