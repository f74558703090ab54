package handover.tabular;

import handover.solver.Deadline;
import java.util.Arrays;
import java.util.random.RandomGenerator;

/**
 * {@link BoundedSearch} from the start, offline, until its bounds are as close as asked for; the policy then does what the best vector
 * begins with. A reference for what can be earned, where there is time.
 *
 * @param gap between the bounds at which it stops, relative to the value
 * @param most beliefs weighed, at least 1
 */
record PointBased(double gap, int most) implements TabularSolver {
    /** What offline work found out. */
    record Found(Learned learned, double lower, double upper, int depth, int nodes) {}

    @Override
    public String name() {
        return "point-based:gap=" + gap + ",most=" + most;
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        Found found = learn(pomdp, gap, most, random.nextLong());
        Alphas vectors = found.learned.vectors();
        Alphas informed = found.learned.bounds().upper();
        double[] start = pomdp.start();
        return (belief, deadline, chance) -> {
            int best = vectors.best(belief);
            double lower = TabularPomdp.dot(belief, vectors.values(), vectors.at(best));
            double upper = Arrays.equals(belief, start) ? found.upper : informed.value(belief);
            return new TabularDecision(vectors.act(best), lower, Math.max(lower, upper), found.depth, found.nodes, true);
        };
    }

    /** Searches from the start. */
    static Found learn(TabularPomdp pomdp, double gap, int most, long seed) {
        Learned nothing = Learned.nothing(pomdp);
        BoundedSearch search = new BoundedSearch(pomdp, nothing);
        search.search(pomdp.start(), new BoundedSearch.Order(gap, false, most, seed), Deadline.NONE);
        return new Found(search.learned(), search.lower(), search.upper(), search.depth(), search.nodes());
    }
}
