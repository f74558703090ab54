package handover.solver;

import handover.domain.HandoverDomain;
import handover.math.Simplex;
import java.util.random.RandomGenerator;

/**
 * POSS, the report's solver: {@link SparseSampling} on the belief MDP. Without a deadline it looks exactly {@code horizon}
 * acts ahead; with one it deepens from 1 to {@code horizon} until the deadline passes and answers with the deepest level
 * that it finished (looking one act ahead is always finished).
 *
 * @param horizon H, acts to look ahead, at least 1
 * @param width C, observations sampled for each act, at least 1
 * @param leaves whether beliefs at the horizon are worth what the best simple policy earns there (hand over the likeliest, ask in turn, or
 *     wait), or 0
 */
public record Poss(int horizon, int width, boolean leaves) implements Solver {
    /** Throws {@link IllegalArgumentException} for a horizon or width below 1. */
    public Poss {
        if (horizon < 1 || width < 1) {
            throw new IllegalArgumentException("poss: expected H >= 1 and C >= 1, got H=" + horizon + ", C=" + width);
        }
    }

    @Override
    public String name() {
        return "poss:H=" + horizon + ",C=" + width + (leaves ? "" : ",leaf=zero");
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return new Searches(domain.start(), Deepening::new);
    }

    private final class Deepening<N> implements Searches.Search<N> {
        private final SparseSampling<N> sampling;
        private final double[] next;

        Deepening(BeliefMdp<N> mdp, int acts) {
            sampling = new SparseSampling<>(mdp, width, leaves);
            next = new double[acts];
        }

        @Override
        public Searches.Result search(N root, Deadline deadline, long seed, double[] q) {
            long before = sampling.nodes();
            int depth = deadline == Deadline.NONE ? horizon : 1;
            sampling.values(root, depth, seed, Deadline.NONE, q);
            while (depth < horizon && !deadline.passed() && sampling.values(root, depth + 1, seed, deadline, next)) {
                System.arraycopy(next, 0, q, 0, q.length);
                depth++;
            }
            return new Searches.Result(Simplex.argmax(q, q.length), depth, sampling.nodes() - before, depth == horizon, null);
        }
    }
}
