package handover.tabular;

import handover.solver.Deadline;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.random.RandomGenerator;

/**
 * {@link BoundedSearch} from the belief of each decision, on top of what a search from the start learnt offline. Stops once the act is
 * certain to be the best, or the bounds are close, or {@code most} beliefs were weighed, or the deadline passes.
 *
 * @param gap between the bounds at which it stops, relative to the value
 * @param warm beliefs weighed offline; 0 for none
 * @param most beliefs weighed for a decision, at least 1
 */
record AnytimeTabular(double gap, int warm, int most) implements TabularSolver {
    @Override
    public String name() {
        return "anytime:gap=" + gap + ",warm=" + warm + ",most=" + most;
    }

    @Override
    public TabularPolicy solve(TabularPomdp pomdp, RandomGenerator random) {
        Learned learned = PointBased.learn(pomdp, gap, warm, random.nextLong()).learned();
        ConcurrentLinkedDeque<BoundedSearch> idle = new ConcurrentLinkedDeque<>();
        return (belief, deadline, chance) -> {
            BoundedSearch search = idle.pollFirst();
            if (search == null) {
                search = new BoundedSearch(pomdp, learned);
            }
            try {
                return decide(search, learned, belief, deadline, chance.nextLong());
            } finally {
                idle.addFirst(search);
            }
        };
    }

    private TabularDecision decide(BoundedSearch search, Learned learned, double[] belief, Deadline deadline, long seed) {
        search.search(belief, new BoundedSearch.Order(gap, true, Math.max(most, learned.size() + 1), seed), deadline);
        return new TabularDecision(search.best(), search.lower(), search.upper(), search.depth(), search.nodes(), !search.stopped());
    }
}
