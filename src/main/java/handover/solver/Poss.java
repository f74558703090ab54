package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.ConcurrentMap;
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
    /** What is kept about tables is dropped when there are more of them: where objects keep moving, old ones do not return. */
    private static final int MOST_SCENES = 256;

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
        Searching policy = new Searching();
        policy.prepare(domain.start());
        return policy;
    }

    /** Shares what is computed once per scene; each decision borrows a search for itself. */
    private final class Searching implements Policy {
        private final ConcurrentMap<Scene, Evidence> evidence = new ConcurrentHashMap<>();
        private final ConcurrentMap<Scene, ConcurrentLinkedDeque<Search>> idle = new ConcurrentHashMap<>();

        /** Computes what a first decision would otherwise wait for. */
        void prepare(Scene scene) {
            evidence.computeIfAbsent(scene, Evidence::new);
            idle.computeIfAbsent(scene, s -> new ConcurrentLinkedDeque<>()).add(new Search(scene));
        }

        @Override
        public Decision decide(HandoverBelief belief, Deadline deadline, RandomGenerator random) {
            if (evidence.size() > MOST_SCENES) {
                evidence.clear();
                idle.clear();
            }
            var searches = idle.computeIfAbsent(belief.scene(), s -> new ConcurrentLinkedDeque<>());
            Search search = searches.pollFirst();
            if (search == null) {
                search = new Search(belief.scene());
            }
            try {
                return search.decide(belief, deadline, random.nextLong());
            } finally {
                searches.addFirst(search);
            }
        }

        /** One thread's buffers. */
        private final class Search {
            private final HandoverSearch mdp;
            private final HandoverSearch.Node root;
            private final SparseSampling<HandoverSearch.Node> sampling;
            private double[] best;
            private double[] next;

            Search(Scene scene) {
                mdp = new HandoverSearch(scene, evidence);
                root = mdp.node();
                sampling = new SparseSampling<>(mdp, width, leaves);
                best = new double[scene.acts().size()];
                next = new double[scene.acts().size()];
            }

            Decision decide(HandoverBelief belief, Deadline deadline, long seed) {
                long before = sampling.nodes();
                root.load(belief);
                int depth = 0;
                if (deadline == Deadline.NONE) {
                    sampling.values(root, horizon, seed, deadline, best);
                    depth = horizon;
                } else {
                    sampling.values(root, 1, seed, Deadline.NONE, best);
                    depth = 1;
                    while (depth < horizon && !deadline.passed()
                            && sampling.values(root, depth + 1, seed, deadline, next)) {
                        double[] swap = best;
                        best = next;
                        next = swap;
                        depth++;
                    }
                }
                return decision(belief.scene().acts(), depth, sampling.nodes() - before);
            }

            private Decision decision(List<ActModel> acts, int depth, long nodes) {
                Map<Act, Double> values = new LinkedHashMap<>();
                ActModel choice = acts.get(0);
                for (ActModel m : acts) {
                    values.put(m.act(), best[m.index()]);
                    choice = best[m.index()] > best[choice.index()] ? m : choice;
                }
                return new Decision(choice.act(), values, depth, nodes, depth == horizon);
            }
        }
    }
}
