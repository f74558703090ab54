package handover.solver;

import burlap.behavior.singleagent.pomdp.wrappedmdpalgs.BeliefSparseSampling;
import burlap.behavior.valuefunction.QValue;
import burlap.debugtools.RandomFactory;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState.StateBelief;
import burlap.mdp.singleagent.pomdp.beliefstate.TabularBeliefState;
import burlap.statehashing.ReflectiveHashableStateFactory;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * BURLAP's own {@link BeliefSparseSampling} as it is, on the BURLAP view of a domain, for comparison. Each decision starts
 * afresh. It knows of no deadline, no reward of the belief, no end of an episode and no value at its leaves.
 *
 * @param horizon H, at least 1
 * @param width C, at least 1
 */
public record BurlapSparseSampling(int horizon, int width) implements Solver {
    /** BURLAP's beliefs draw from its one global generator, so that only one decision can be made at a time. */
    private static final Object LOCK = new Object();

    @Override
    public String name() {
        return "burlap:H=" + horizon + ",C=" + width;
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            synchronized (LOCK) {
                RandomFactory.seedMapped(0, chance.nextLong());
                return decide(domain, belief, chance);
            }
        };
    }

    private Decision decide(HandoverDomain domain, HandoverBelief belief, RandomGenerator chance) {
        PODomain burlap = domain.generateDomain(chance);
        BeliefSparseSampling planner = new BeliefSparseSampling(burlap, domain.discount(),
                new ReflectiveHashableStateFactory(), horizon, width);
        planner.getSparseSamplingPlanner().toggleDebugPrinting(false);
        Map<Act, Double> values = new LinkedHashMap<>();
        for (QValue q : planner.qValues(tabular(burlap, domain, belief))) {
            values.put((Act) q.a, q.q);
        }
        Act best = values.entrySet().stream().max(Map.Entry.comparingByValue()).orElseThrow().getKey();
        return new Decision(best, values, horizon, planner.getSparseSamplingPlanner().getNumberOfValueEsitmates(), true);
    }

    private static TabularBeliefState tabular(PODomain burlap, HandoverDomain domain, HandoverBelief belief) {
        TabularBeliefState table = new TabularBeliefState(burlap, burlap.getStateEnumerator());
        for (StateBelief b : belief.nonZeroBeliefs()) {
            domain.hidden((HandoverState) b.s).forEach((s, p) -> {
                if (p > 0) {
                    table.setBelief(s, p * b.belief);
                }
            });
        }
        return table;
    }
}
