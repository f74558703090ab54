package handover.domain;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.model.TransitionProb;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * The transition and reward model over {@link CommunicatedState}s (MODEL 7): that of the base, with omega_H' drawn from h'
 * and paid for where it is what is wanted. A completed pick is paid for before it restarts the human's belief, from which
 * the next omega_H is then drawn. Thread safe except {@link #sample}.
 */
final class CommunicatedModel implements FullModel {
    private final CommunicatedObjectDomain domain;
    private final HandoverModel base;
    private final RandomGenerator random;

    CommunicatedModel(CommunicatedObjectDomain domain, RandomGenerator random) {
        this.domain = domain;
        this.base = new HandoverModel(domain, random);
        this.random = random;
    }

    @Override
    public List<TransitionProb> transitions(State s, Action a) {
        HandoverState state = ((CommunicatedState) s).base();
        if (state.task().done()) {
            return List.of(new TransitionProb(1, new EnvironmentOutcome(s, a, s, 0, true)));
        }
        List<TransitionProb> all = new ArrayList<>();
        for (HandoverModel.Outcome o : base.outcomes(state, (Act) a)) {
            for (int expected = 0; expected < o.human().length; expected++) {
                addNext(s, a, o, expected, o.p() * o.human()[expected], all);
            }
        }
        return all;
    }

    private void addNext(State s, Action a, HandoverModel.Outcome o, int expected, double p, List<TransitionProb> all) {
        boolean restarts = o.next().human() != o.human();
        double[] next = restarts ? o.next().human() : Simplex.vertex(o.human().length, expected);
        for (int e = 0; e < Math.max(1, next.length); e++) {
            double q = next.length == 0 ? p : p * next[e];
            if (q > 0) {
                CommunicatedState to = new CommunicatedState(o.next(), next.length == 0 ? -1 : e);
                all.add(new TransitionProb(q, new EnvironmentOutcome(s, a, to, reward(o, expected), to.base().task().done())));
            }
        }
    }

    private double reward(HandoverModel.Outcome o, int expected) {
        return o.reward() + domain.communicated(o.wanted(), expected, o.human());
    }

    @Override
    public EnvironmentOutcome sample(State s, Action a) {
        HandoverState state = ((CommunicatedState) s).base();
        if (state.task().done()) {
            return new EnvironmentOutcome(s, a, s, 0, true);
        }
        HandoverModel.Outcome o = base.draw(state, (Act) a, random, random);
        int expected = Simplex.sample(o.human(), o.human().length, random);
        boolean restarts = o.next().human() != o.human();
        CommunicatedState next = restarts ? CommunicatedState.draw(o.next(), random) : new CommunicatedState(o.next(), expected);
        return new EnvironmentOutcome(s, a, next, reward(o, expected), next.base().task().done());
    }

    @Override
    public boolean terminal(State s) {
        return ((CommunicatedState) s).base().task().done();
    }
}
