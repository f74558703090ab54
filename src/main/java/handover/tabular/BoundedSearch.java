package handover.tabular;

import handover.math.SeededRandom;
import handover.solver.Deadline;
import java.util.Arrays;

/**
 * Heuristic search from a belief with a bound on its value from both sides, which close in on it. A trial goes down from the root of a
 * {@link BeliefGraph} and back, and backs up every belief on its way back. Some trials go down by the bounds: by the act with the
 * highest upper one and the observation whose belief contributes most to the gap. The others go where the best policy so far would: by
 * the act of the best vector and an observation drawn as the model says. Acts are expanded only when they are needed. Used by one
 * thread; what it allocates it uses again.
 *
 * <p>Source: HSVI2 (Smith and Simmons, "Point-based POMDP algorithms: improved analysis and implementation", 2005), here on a graph
 * with merged beliefs, with acts expanded on demand as in branch and bound, and with sampled trials as in PBVI (Pineau, Gordon and
 * Thrun, "Point-based value iteration: an anytime algorithm for POMDPs", 2003).
 */
final class BoundedSearch {
    private static final int DEEPEST = 2000;
    private static final double TINY = 1e-12;
    private static final double HUGE = 1e300;
    private static final double SMALL = 0.01;
    /** A trial by the bounds stops where the gap is this share of the root's, discounted. */
    private static final double SHARE = 0.8;
    /** Of so many trials one goes by the bounds, the others by the policy. */
    private static final int TURNS = 5;
    /** Trials by the policy go so far that what comes later counts for less than this. */
    private static final double FAR = 0.3;

    private final TabularPomdp m;
    private final int acts;
    private final int far;
    /** Bounds that are as close as this may never come closer, because beliefs that are almost equal are one node. */
    private final double rounding;
    private final Clock clock = new Clock();
    private final BeliefGraph graph;
    private final SeededRandom random = new SeededRandom();
    private final int[] path = new int[DEEPEST + 1];
    private Order order;
    private int root;
    private int depth;
    private int trials;
    private double span;
    private boolean stopped;

    /**
     * What a search is to do.
     *
     * @param gap between the bounds at which it stops, relative to the value; not negative
     * @param settle whether it also stops once no other act can be better than the best one
     * @param most beliefs at which it stops
     * @param seed which observations trials by the policy follow
     */
    record Order(double gap, boolean settle, int most, long seed) {}

    BoundedSearch(TabularPomdp m, Learned learned) {
        this.m = m;
        acts = m.acts().size();
        far = m.discount() == 0 ? 1 : (int) Math.max(1, Math.min(DEEPEST, Math.ceil(Math.log(FAR) / Math.log(m.discount()))));
        graph = new BeliefGraph(m, learned, clock);
        double largest = Arrays.stream(m.reward).map(Math::abs).max().orElseThrow();
        rounding = 4 * BeliefStore.SAME * largest / (1 - m.discount()) / (1 - m.discount());
    }

    /** Searches from a belief, from what was learnt before, until what is asked for is done or the deadline passes. */
    void search(double[] belief, Order what, Deadline deadline) {
        order = what;
        random.seed(what.seed);
        depth = 0;
        trials = 0;
        clock.start(deadline);
        root = graph.reset(belief);
        span = graph.upper(root) - graph.lower(root);
        boolean done = false;
        stopped = deadline.passed();
        while (!done && !stopped) {
            done = graph.upper(root) - graph.lower(root) <= precision() || order.settle && settled()
                    || graph.size() >= order.most;
            stopped = !done && (!trial() || deadline.passed());
        }
    }

    /** The gap at which it stops; where the value is about 0, relative to what the bounds span at first. */
    private double precision() {
        return Math.max(rounding, order.gap * Math.max(Math.abs(graph.upper(root)), SMALL * span));
    }

    /** Whether no other act can be better than the one that is best by its lower bound. */
    private boolean settled() {
        if (!graph.opened(root)) {
            return false;
        }
        int best = best();
        double sure = graph.actLower(root, best) + TINY;
        for (int a = 0; a < acts; a++) {
            if (a != best && graph.actUpper(root, a) > sure) {
                return false;
            }
        }
        return true;
    }

    /** Goes down once and back. False if the deadline passed meanwhile. */
    private boolean trial() {
        boolean byBounds = trials++ % TURNS == 0;
        int at = root;
        int d = 0;
        double slack = byBounds ? Math.max(precision(), SHARE * (graph.upper(root) - graph.lower(root))) : precision();
        while (at >= 0 && d < (byBounds ? DEEPEST : far)) {
            graph.refresh(at);
            if (clock.late() || graph.upper(at) - graph.lower(at) <= slack || d > 0 && graph.size() >= order.most) {
                break;
            }
            int usual = graph.usualAct(at);
            int act = byBounds || !graph.expanded(at, usual) ? promising(at) : usual;
            if (clock.late()) {
                break;
            }
            path[d++] = at;
            slack = Math.min(slack / m.discount(), HUGE);
            at = byBounds ? widest(at, act, slack) : sampled(at, act);
        }
        depth = Math.max(depth, d);
        for (int k = d - 1; k >= 0 && !clock.late(); k--) {
            graph.backup(path[k]);
        }
        return !clock.late();
    }

    /** The act with the highest upper bound, expanded; undefined if the deadline passed. */
    private int promising(int at) {
        if (!graph.opened(at)) {
            graph.open(at);
        }
        while (true) {
            int best = 0;
            for (int a = 1; a < acts; a++) {
                best = graph.actUpper(at, a) > graph.actUpper(at, best) ? a : best;
            }
            if (graph.expanded(at, best) || !graph.expand(at, best)) {
                return best;
            }
        }
    }

    /** The node that contributes most to the gap beyond what is allowed for; -1 if none does. */
    private int widest(int at, int act, double slack) {
        int best = -1;
        double most = 0;
        for (int o = 0; o < m.observations().size(); o++) {
            int c = graph.child(at, act, o);
            double excess = c < 0 ? 0 : graph.weight(at, act, o) * (graph.upper(c) - graph.lower(c) - slack);
            if (excess > most) {
                most = excess;
                best = c;
            }
        }
        return best;
    }

    private int sampled(int at, int act) {
        double u = random.nextDouble();
        int last = -1;
        for (int o = 0; o < m.observations().size() && u >= 0; o++) {
            int c = graph.child(at, act, o);
            last = c >= 0 ? c : last;
            u -= graph.weight(at, act, o);
        }
        return last;
    }

    // ---- what was found ------------------------------------------------------------------------------------------

    double lower() {
        return graph.lower(root);
    }

    double upper() {
        return graph.upper(root);
    }

    /** The act with the best lower bound, by its upper bound among equals. */
    int best() {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int a = 0; a < acts; a++) {
            double v = graph.actLower(root, a);
            if (v > most || v == most && graph.actUpper(root, a) > graph.actUpper(root, best)) {
                most = v;
                best = a;
            }
        }
        return best;
    }

    int nodes() {
        return graph.size();
    }

    int depth() {
        return depth;
    }

    /** Whether the search stopped because of its deadline. */
    boolean stopped() {
        return stopped;
    }

    Learned learned() {
        return graph.learned();
    }
}
