package handover.belief;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.beliefstate.BeliefState;
import burlap.mdp.singleagent.pomdp.beliefstate.BeliefUpdate;
import handover.domain.Act;
import handover.domain.Observation;

/** The filter in BURLAP's form: one act and all that was sensed until the next. Stateless, thread safe. */
public final class HandoverBeliefUpdate implements BeliefUpdate {
    @Override
    public HandoverBelief update(BeliefState belief, State observation, Action act) {
        return ((HandoverBelief) belief).after((Act) act).given((Observation) observation);
    }
}
