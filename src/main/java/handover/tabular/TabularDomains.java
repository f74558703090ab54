package handover.tabular;

import burlap.behavior.singleagent.auxiliary.StateEnumerator;
import burlap.mdp.core.action.Action;
import burlap.mdp.core.action.ActionUtils;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.model.TransitionProb;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.observations.DiscreteObservationFunction;
import java.util.ArrayList;
import java.util.List;

/** Any tabular BURLAP domain as a {@link TabularPomdp}. */
public final class TabularDomains {
    private TabularDomains() {}

    /**
     * The model of a BURLAP domain with enumerated states, a {@link FullModel}, discrete observations, and the same acts in
     * every state. Names are the texts of states, acts and observations; states come in the order of the enumerator.
     *
     * @param start belief over the enumerated states, null for uniform
     * @throws IllegalArgumentException if the domain is not tabular
     */
    public static TabularPomdp of(PODomain domain, double discount, double[] start) {
        if (!(domain.getModel() instanceof FullModel model)
                || !(domain.getObservationFunction() instanceof DiscreteObservationFunction senses)
                || !domain.providesStateEnumerator()) {
            throw new IllegalArgumentException(
                    "expected a domain with a FullModel, a DiscreteObservationFunction and a StateEnumerator");
        }
        StateEnumerator enumerator = domain.getStateEnumerator();
        List<State> states = new ArrayList<>();
        for (int s = 0; s < enumerator.numStatesEnumerated(); s++) {
            states.add(enumerator.getStateForEnumerationId(s));
        }
        List<Action> acts = ActionUtils.allApplicableActionsForTypes(domain.getActionTypes(), states.get(0));
        List<State> observations = senses.allObservations();
        TabularBuilder to = new TabularBuilder(discount, Names.of(states), Names.of(acts), Names.of(observations));
        if (start != null) {
            to.start(start);
        }
        for (int a = 0; a < acts.size(); a++) {
            for (int s = 0; s < states.size(); s++) {
                for (int o = 0; o < observations.size(); o++) {
                    to.observation(a, s, o, senses.probability(observations.get(o), states.get(s), acts.get(a)));
                }
                addTransitions(to, model, enumerator, states, acts.get(a), a, s);
            }
        }
        return to.build();
    }

    private static void addTransitions(TabularBuilder to, FullModel model, StateEnumerator enumerator, List<State> states, Action act,
            int a, int s) {
        if (model.terminal(states.get(s))) {
            to.transition(a, s, s, 1);
            return;
        }
        double reward = 0;
        for (TransitionProb t : model.transitions(states.get(s), act)) {
            int next = enumerator.getEnumeratedID(t.eo.op);
            if (next >= states.size()) {
                throw new IllegalArgumentException("expected all reachable states to be enumerated, found another: " + t.eo.op);
            }
            to.transition(a, s, next, to.transition(a, s, next) + t.p);
            reward += t.p * t.eo.r;
        }
        to.reward(a, s, -1, -1, reward);
    }
}
