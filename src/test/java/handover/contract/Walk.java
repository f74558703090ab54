package handover.contract;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.action.ActionType;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.observations.ObservationFunction;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.PickType;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/** States and acts that random episodes of a domain pass through, with the domain's BURLAP view; fixed seed. */
final class Walk {
    private static final long SEED = 20261122;
    private static final int EPISODES = 12;
    private static final int STEPS = 20;

    final HandoverDomain domain;
    final PODomain burlap;
    final FullModel model;
    final ObservationFunction senses;
    final RandomGenerator random = new SplittableRandom(SEED);

    /** A state that can be reached, an act that is legal there, and what it led to once. */
    record Visit(State state, Action act, State next, double reward) {
        @Override
        public String toString() {
            return "doing " + act + " in " + line(state);
        }
    }

    /** A state on one line. */
    static String line(State s) {
        return String.valueOf(s).replaceAll("\\s*\\R\\s*", "; ");
    }

    Walk(HandoverDomain domain) {
        this.domain = domain;
        this.burlap = domain.generateDomain(new SplittableRandom(SEED + 1));
        this.model = (FullModel) burlap.getModel();
        this.senses = burlap.getObservationFunction();
    }

    List<Action> legal(State s) {
        List<Action> all = new ArrayList<>();
        for (ActionType type : burlap.getActionTypes()) {
            all.addAll(type.allApplicableActions(s));
        }
        return all;
    }

    /** A hidden state at the start of an episode. */
    State start() {
        int i = Simplex.sample(domain.prior(domain.start()), domain.start().size(), random);
        String wanted = domain.start().objects().get(i).name();
        Map<State, Double> states = domain.hidden(domain.initialState(wanted));
        List<State> all = List.copyOf(states.keySet());
        return all.get(Simplex.sample(all.stream().mapToDouble(states::get).toArray(), all.size(), random));
    }

    /** What random episodes pass through. */
    List<Visit> visits() {
        List<Visit> all = new ArrayList<>();
        for (int e = 0; e < EPISODES; e++) {
            State s = start();
            Action last = null;
            for (int k = 0; k < STEPS && !model.terminal(s); k++) {
                Action act = choose(s, last);
                EnvironmentOutcome o = model.sample(s, act);
                all.add(new Visit(s, act, o.op, o.r));
                s = o.op;
                last = act;
            }
        }
        return all;
    }

    /** A legal act: often the last one again, or a reach for what is wanted, so that picks of several increments complete. */
    Action choose(State s, Action last) {
        List<Action> acts = legal(s);
        Action right = Act.of(PickType.VERB, wanted(s));
        Action liked = random.nextInt(2) == 0 ? right : last;
        boolean on = acts.contains(liked) && random.nextInt(2) == 0;
        return on ? liked : acts.get(random.nextInt(acts.size()));
    }

    private static String wanted(State s) {
        HandoverState base = base(s);
        return base.task().scene().objects().get(base.wanted()).name();
    }

    static HandoverState base(State s) {
        return HandoverState.of(s);
    }
}
