package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.math.SeededRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;

/**
 * The anytime planner: {@link Racing} on the belief MDP, at depth 2 among all acts, then deeper among those that may still be
 * the best. It can be stopped at any time; until then, time goes to the acts between which the choice is close.
 *
 * @param horizon H, acts that the last race looks ahead, at least 2
 * @param draws C, observations drawn of each act in the last race, at least 8; each race before it draws twice as many
 */
public record Anytime(int horizon, int draws) implements Solver {
    /** Observations drawn for each act below the root. */
    private static final int WIDTH = 8;
    /** Acts that are no worse than this stay for the next race, which sees further. */
    private static final double SLACK = 0.3;
    private static final int FEWEST_DRAWS = 8;
    /** Rollouts of each act, at most. */
    private static final int ROLLOUTS = 512;
    /** So often a first decision, whose result is not used, looks at the clock: what it loads and fills is not waited for later. */
    private static final int WARM_UP = 2000;

    /** Throws {@link IllegalArgumentException} for a horizon below 2 or fewer than 8 draws. */
    public Anytime {
        if (horizon < 2 || draws < FEWEST_DRAWS) {
            throw new IllegalArgumentException("anytime: expected H >= 2 and C >= " + FEWEST_DRAWS + ", got H=" + horizon + ", C=" + draws);
        }
    }

    @Override
    public String name() {
        return "anytime:H=" + horizon + ",C=" + draws;
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        Policy policy = new Searches(domain.start(), Raced::new);
        AtomicInteger checks = new AtomicInteger();
        policy.decide(HandoverBelief.initial(domain), () -> checks.incrementAndGet() > WARM_UP, new SeededRandom());
        return policy;
    }

    private List<Racing.Race> races() {
        List<Racing.Race> races = new ArrayList<>();
        for (int h = 2; h <= horizon; h++) {
            races.add(new Racing.Race(h, WIDTH, draws << (horizon - h), h == horizon ? 0 : SLACK));
        }
        races.add(1, Racing.Race.ofRollouts(ROLLOUTS));
        return races;
    }

    private final class Raced<N> implements Searches.Search {
        private final BeliefSearch<N> mdp;
        private final N root;
        private final Racing<N> racing;

        Raced(BeliefSearch<N> mdp, int acts) {
            this.mdp = mdp;
            root = mdp.node();
            racing = new Racing<>(mdp, races(), acts);
        }

        @Override
        public Searches.Result search(HandoverBelief belief, Deadline deadline, long seed, double[] q) {
            long before = racing.nodes();
            mdp.load(root, belief);
            int best = racing.run(root, seed, deadline, q);
            double upper = IntStream.range(0, q.length).mapToDouble(a -> mdp.bound(root, a)).max().orElseThrow();
            Bounds bounds = upper == Double.POSITIVE_INFINITY ? null : new Bounds(Math.min(racing.lower(), upper), upper);
            return new Searches.Result(best, racing.depth(), racing.nodes() - before, racing.finished(), bounds);
        }
    }
}
