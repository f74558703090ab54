package handover.solver;

import burlap.behavior.policy.GreedyQPolicy;
import burlap.behavior.singleagent.MDPSolver;
import burlap.behavior.singleagent.planning.Planner;
import burlap.behavior.valuefunction.QProvider;
import burlap.behavior.valuefunction.QValue;
import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.statehashing.ReflectiveHashableStateFactory;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * Any of our policies as a BURLAP planner on {@link HandoverBelief}s, so that BURLAP's agents and policies can use it. A
 * policy that estimates no values gives its act the value 1 and no other act. Used by one thread at a time.
 */
public final class BurlapPlanner extends MDPSolver implements Planner, QProvider {
    private final Policy policy;
    private final RandomGenerator random;

    /**
     * @param random all the chance that decisions use
     */
    public BurlapPlanner(HandoverDomain handover, PODomain domain, Solver solver, RandomGenerator random) {
        this.policy = solver.solve(handover, random);
        this.random = random;
        solverInit(domain, handover.discount(), new ReflectiveHashableStateFactory());
    }

    /** What our policy decides at a belief, as BURLAP's act. */
    public burlap.behavior.policy.Policy policy() {
        return new GreedyQPolicy(this);
    }

    @Override
    public burlap.behavior.policy.Policy planFromState(State initialState) {
        return policy();
    }

    @Override
    public List<QValue> qValues(State s) {
        if (((HandoverBelief) s).task().done()) {
            return List.of(new QValue(s, Act.WAIT, 0));
        }
        Decision decision = policy.decide((HandoverBelief) s, Deadline.NONE, random);
        if (decision.values().isEmpty()) {
            return List.of(new QValue(s, decision.act(), 1));
        }
        return decision.values().entrySet().stream().map(e -> new QValue(s, e.getKey(), e.getValue())).toList();
    }

    /** Throws {@link IllegalArgumentException} if the policy gives the act no value. */
    @Override
    public double qValue(State s, Action a) {
        return qValues(s).stream().filter(q -> q.a.equals(a)).mapToDouble(q -> q.q).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no value for " + a));
    }

    @Override
    public double value(State s) {
        return ((HandoverBelief) s).task().done() ? 0 : QProvider.Helper.maxQ(this, s);
    }

    /** Nothing to forget: decisions do not depend on those before. */
    @Override
    public void resetSolver() {}
}
