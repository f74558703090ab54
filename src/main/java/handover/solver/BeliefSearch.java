package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Scene;
import java.util.concurrent.ConcurrentMap;

/** A belief MDP of a handover domain, which can start at any belief. */
interface BeliefSearch<N> extends BeliefMdp<N> {
    /** Fills a node (modified) with a belief. */
    void load(N node, HandoverBelief belief);

    /** Another one for another thread, which shares what is computed once for a table. */
    BeliefSearch<N> another();

    /** The search for beliefs over at most the objects of {@code largest}: over minds only where they are uncertain. */
    static BeliefSearch<?> of(Scene largest, ConcurrentMap<Scene, Evidence> evidence) {
        HandoverSearch plain = new HandoverSearch(largest, evidence);
        return largest.perceivedExactly() ? plain
                : new NestedSearch(plain, NestedSearch.minds(largest.domain().spec().perception()));
    }
}
