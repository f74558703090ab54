package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Scene;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.ConcurrentMap;
import java.util.random.RandomGenerator;

/**
 * A policy of searches on the belief MDP: each decision borrows a search for itself; what is computed once for a table is
 * shared by all. Thread safe.
 */
final class Searches implements Policy {
    /** What is kept about tables is dropped when there are more of them: where objects keep moving, old ones do not return. */
    private static final int MOST_SCENES = 256;

    /** The buffers of one decision at a time, for one table. */
    interface Search {
        /**
         * Fills in the values of all acts.
         *
         * @param q modified
         */
        Result search(HandoverBelief belief, Deadline deadline, long seed, double[] q);
    }

    /** Makes a search. */
    interface Maker {
        <N> Search search(BeliefSearch<N> mdp, int acts);
    }

    /**
     * What a search came to.
     *
     * @param act index of the best act
     */
    record Result(int act, int depth, long nodes, boolean finished, Bounds bounds) {}

    private final Maker make;
    private final ConcurrentMap<Scene, Evidence> evidence = new ConcurrentHashMap<>();
    private final ConcurrentMap<Scene, ConcurrentLinkedDeque<Borrowed>> idle = new ConcurrentHashMap<>();

    /** @param first the table of the first decision, for which it shall not wait */
    Searches(Scene first, Maker make) {
        this.make = make;
        idle(first).add(new Borrowed(first));
    }

    private ConcurrentLinkedDeque<Borrowed> idle(Scene scene) {
        return idle.computeIfAbsent(scene, s -> new ConcurrentLinkedDeque<>());
    }

    @Override
    public Decision decide(HandoverBelief belief, Deadline deadline, RandomGenerator random) {
        if (evidence.size() > MOST_SCENES) {
            evidence.clear();
            idle.clear();
        }
        ConcurrentLinkedDeque<Borrowed> free = idle(belief.scene());
        Borrowed search = free.pollFirst();
        if (search == null) {
            search = new Borrowed(belief.scene());
        }
        try {
            return search.decide(belief, deadline, random.nextLong());
        } finally {
            free.addFirst(search);
        }
    }

    private final class Borrowed {
        private final Search search;
        private final double[] q;

        Borrowed(Scene scene) {
            q = new double[scene.acts().size()];
            search = make.search(BeliefSearch.of(scene, evidence), q.length);
        }

        Decision decide(HandoverBelief belief, Deadline deadline, long seed) {
            Result result = search.search(belief, deadline, seed, q);
            List<ActModel> acts = belief.scene().acts();
            Map<Act, Double> values = new LinkedHashMap<>();
            acts.forEach(m -> values.put(m.act(), q[m.index()]));
            return new Decision(acts.get(result.act).act(), values, result.depth, result.nodes, result.finished, "", result.bounds);
        }
    }
}
