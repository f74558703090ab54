package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.math.Simplex;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * POSS, the report's solver: {@link SparseSampling} on the belief MDP. Without a deadline it looks exactly {@code horizon}
 * acts ahead; with one it deepens from 1 to {@code horizon} until the deadline passes and answers with the deepest level
 * that it finished (looking one act ahead is always finished).
 *
 * @param horizon H, acts to look ahead, at least 1
 * @param width C, observations sampled for each act, at least 1
 * @param leaves whether beliefs at the horizon are worth what the best simple policy earns there (hand over the likeliest, ask in turn, or
 *     wait), or 0
 * @param threads among which the acts at the root are divided, at least 1; the values are the same for any number
 */
public record Poss(int horizon, int width, boolean leaves, int threads) implements Solver {
    /** Throws {@link IllegalArgumentException} for a horizon, width or number of threads below 1. */
    public Poss {
        if (horizon < 1 || width < 1 || threads < 1) {
            throw new IllegalArgumentException("poss: expected H >= 1, C >= 1 and threads >= 1, got H=" + horizon + ", C=" + width
                    + ", threads=" + threads);
        }
    }

    /** On one thread. */
    public Poss(int horizon, int width, boolean leaves) {
        this(horizon, width, leaves, 1);
    }

    @Override
    public String name() {
        return "poss:H=" + horizon + ",C=" + width + (leaves ? "" : ",leaf=zero") + (threads == 1 ? "" : ",threads=" + threads);
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return new Searches(domain.start(), Deepening::new);
    }

    private final class Deepening<N> implements Searches.Search {
        private final List<Worker<N>> workers;
        private final double[] next;

        Deepening(BeliefSearch<N> mdp, int acts) {
            workers = Stream.iterate(mdp, BeliefSearch::another).limit(threads).map(m -> worker(m)).toList();
            next = new double[acts];
        }

        private Worker<N> worker(BeliefSearch<N> mdp) {
            return new Worker<>(mdp, mdp.node(), new SparseSampling<>(mdp, width, leaves));
        }

        @Override
        public Searches.Result search(HandoverBelief belief, Deadline deadline, long seed, double[] q) {
            long before = nodes();
            workers.forEach(w -> w.mdp.load(w.root, belief));
            int depth = deadline == Deadline.NONE ? horizon : 1;
            values(depth, seed, Deadline.NONE, q);
            while (depth < horizon && !deadline.passed() && values(depth + 1, seed, deadline, next)) {
                System.arraycopy(next, 0, q, 0, q.length);
                depth++;
            }
            return new Searches.Result(Simplex.argmax(q, q.length), depth, nodes() - before, depth == horizon, null);
        }

        private boolean values(int depth, long seed, Deadline deadline, double[] q) {
            if (threads == 1) {
                return workers.get(0).values(depth, seed, deadline, q, 0, 1);
            }
            return IntStream.range(0, threads).parallel()
                    .filter(k -> workers.get(k).values(depth, seed, deadline, q, k, threads)).count() == threads;
        }

        private long nodes() {
            return workers.stream().mapToLong(w -> w.sampling.nodes()).sum();
        }
    }

    private record Worker<N>(BeliefSearch<N> mdp, N root, SparseSampling<N> sampling) {
        boolean values(int depth, long seed, Deadline deadline, double[] q, int first, int step) {
            return sampling.values(root, depth, seed, deadline, q, first, step);
        }
    }
}
