package handover.solver;

import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;

/**
 * The best act with leaves after it: acts are tried in the order in which they may be the best, until a bound shows that no other
 * is. The value is that of trying all, to the last bit. Used by one thread at a time.
 */
final class LastLevel {
    /** Keeps bounds above values that were added up in another order. */
    private static final double ROUNDING = 1e-9;

    private final HandoverSearch search;
    private final HandoverDomain domain;
    private final CommitOrWait leaves;
    private final UpperBounds bounds;
    private final int n;
    /** By object, the act that reaches for it. */
    private final int[] picks;
    /** The same in the order of the acts. */
    private final int[] picksInOrder;

    LastLevel(HandoverSearch search, Scene scene, CommitOrWait leaves) {
        this.search = search;
        this.domain = scene.domain();
        this.leaves = leaves;
        this.bounds = leaves.bounds();
        this.n = scene.size();
        this.picks = leaves.picks();
        this.picksInOrder = scene.acts().stream().filter(ActModel::isPick).mapToInt(ActModel::index).toArray();
    }

    /** As {@link BeliefMdp#last}. */
    double best(HandoverSearch.Node node, HandoverSearch.Node next) {
        SearchBelief b = node.b;
        double later = domain.discount() * boundWithoutPick(node);
        ActEffect likeliest = node.task.effect(picks[b.likeliest()]);
        double best = boundOfPick(node, likeliest) > bounds.match(b) + later
                ? value(node, likeliest, match(node, likeliest), next) : Double.NEGATIVE_INFINITY;
        for (int a : node.task.byReward()) {
            ActEffect effect = node.task.effect(a);
            if (effect.reward() + bounds.match(b) + later <= best) {
                break;
            }
            double match = match(node, effect);
            if (effect.reward() + match + later > best) {
                best = Math.max(best, value(node, effect, match, next));
            }
        }
        for (int a : picksInOrder) {
            ActEffect effect = node.task.effect(a);
            double bound = boundOfPick(node, effect);
            if (bound > best) {
                best = Math.max(best, valueOfPick(node, effect, bound, best, next));
            }
        }
        return best;
    }

    /** The value of an act, or less than {@code best} if its match reward shows that it is not better. */
    private double valueOfPick(HandoverSearch.Node node, ActEffect effect, double bound, double best, HandoverSearch.Node next) {
        double match = match(node, effect);
        boolean hopeless = bound - bounds.match(node.b) + match + ROUNDING < best;
        return hopeless ? Double.NEGATIVE_INFINITY : value(node, effect, match, next);
    }

    private double match(HandoverSearch.Node node, ActEffect effect) {
        return domain.matchReward(node.b.p, node.after(effect.model()), n);
    }

    private double value(HandoverSearch.Node node, ActEffect effect, double match, HandoverSearch.Node next) {
        return search.ending(search.start(node, effect, match, next), true, next);
    }

    /** On a leaf after an act that is no pick. */
    private double boundWithoutPick(HandoverSearch.Node node) {
        SearchBelief b = node.b;
        if (Double.isNaN(b.bound)) {
            b.bound = leaves.bound(node);
        }
        return b.bound;
    }

    /** On a pick with leaves after it, whether it completes or not. */
    private double boundOfPick(HandoverSearch.Node node, ActEffect effect) {
        double outcome = bounds.outcome(node.b.p[effect.model().target()]);
        double now = effect.reward() + bounds.match(node.b);
        if (effect.completes() && effect.stalled() == null) {
            return now + outcome;
        } else if (effect.model().target() == node.b.likeliest()) {
            return Double.POSITIVE_INFINITY;
        }
        double later = domain.discount() * Math.max(bounds.reaching(node.b, effect.model().target()), boundWithoutPick(node));
        return now + (effect.completes() ? Math.max(outcome, later) : later);
    }
}
