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
 * The transition and reward model of a {@link HandoverDomain} over {@link HandoverState}s. The next state carries the
 * human's answer or the pick's outcome, which the observation then shows. The match reward of a state is S(e_omega, h');
 * belief-dependent scores have no reward at this level. Thread safe except {@link #sample(State, Action)}, which draws
 * from the generator that was handed in.
 */
public final class HandoverModel implements FullModel {
    private final HandoverDomain domain;
    private final RandomGenerator random;

    public HandoverModel(HandoverDomain domain, RandomGenerator random) {
        this.domain = domain;
        this.random = random;
    }

    /**
     * What an act may lead to.
     *
     * @param p its probability
     * @param wanted omega when the act takes effect
     * @param human h' after the act, before a completed pick restarts it
     * @param next the state after it
     * @param reward without the match part
     */
    record Outcome(double p, int wanted, double[] human, HandoverState next, double reward) {}

    /**
     * An act and what the human takes it for.
     *
     * @param effect of the act
     * @param seen the effect of what they perceive on the task as they see it; answers come from it
     * @param reward price and annoyance, which who missed the act before does not feel
     */
    private record Reaction(ActEffect effect, ActEffect seen, double reward) {
        static Reaction to(HandoverState s, Act act) {
            ActEffect seen = s.seen().effect(act);
            return new Reaction(s.task().effect(act), seen, seen.reward());
        }

        Reaction perceived(HandoverState s, ActModel act) {
            return act == effect.model() ? this : new Reaction(effect, s.seen().effect(act.index()), reward);
        }

        Reaction stalled() {
            return new Reaction(effect.stalled(), seen.stalled(), reward);
        }
    }

    /** All outcomes of positive probability; throws {@link IllegalArgumentException} if the act is not legal. */
    @Override
    public List<TransitionProb> transitions(State s, Action a) {
        HandoverState state = (HandoverState) s;
        if (state.task().done()) {
            return List.of(new TransitionProb(1, new EnvironmentOutcome(s, a, s, 0, true)));
        }
        return outcomes(state, (Act) a).stream().map(o -> new TransitionProb(o.p, result(s, a, o))).toList();
    }

    private EnvironmentOutcome result(State s, Action a, Outcome o) {
        int n = o.human.length;
        double match = domain.beliefDependentReward() ? 0
                : domain.matchReward(Simplex.vertex(n, o.wanted), o.human, n);
        return new EnvironmentOutcome(s, a, o.next, o.reward + match, o.next.task().done());
    }

    List<Outcome> outcomes(HandoverState s, Act act) {
        Reaction done = Reaction.to(s, act);
        double[] wanted = moved(s);
        List<Outcome> all = new ArrayList<>();
        for (Percept percept : s.task().scene().percepts(done.effect.model())) {
            Reaction r = done.perceived(s, percept.act());
            double[] human = domain.understood(percept.act(), s.human());
            for (int i = 0; i < wanted.length; i++) {
                if (wanted[i] > 0) {
                    double p = percept.probability() * wanted[i];
                    addOutcomes(r, i, human, p * r.effect.advance(), all);
                    if (r.effect.stalled() != null) {
                        addOutcomes(r.stalled(), i, human, p * (1 - r.effect.advance()), all);
                    }
                }
            }
        }
        return all;
    }

    private double[] moved(HandoverState s) {
        double[] wanted = Simplex.vertex(s.human().length, s.wanted());
        Simplex.propagate(domain.spec().tau(), wanted, wanted, wanted.length);
        return wanted;
    }

    private void addOutcomes(Reaction r, int i, double[] human, double p, List<Outcome> all) {
        if (!r.effect.completes()) {
            for (Answer answer : Answer.values()) {
                double q = r.seen.answers(answer)[i];
                if (q > 0) {
                    all.add(answered(r, i, human, answer, p * q));
                }
            }
            return;
        }
        double[] wishes = wishesAfter(r.effect, i);
        for (int j = 0; j < wishes.length; j++) {
            if (wishes[j] > 0) {
                all.add(completed(r, i, human, j, p * wishes[j]));
            }
        }
        if (wishes.length == 0) {
            all.add(completed(r, i, human, -1, p));
        }
    }

    private static Outcome answered(Reaction r, int wanted, double[] human, Answer answer, double p) {
        HandoverState next = new HandoverState(wanted, r.effect.during().answered(answer), human, r.seen.during().answered(answer));
        return new Outcome(p, wanted, human, next, r.reward);
    }

    private Outcome completed(Reaction r, int wanted, double[] human, int wish, double p) {
        boolean right = r.effect.model().target() == wanted;
        Task task = r.effect.during().completed(right);
        HandoverState next = new HandoverState(wish, task, Simplex.uniform(task.scene().size()));
        return new Outcome(p, wanted, human, next, r.reward + domain.pickReward(right));
    }

    /** What the human wants once the pick completed: a new wish, or what they wanted all the time. */
    private static double[] wishesAfter(ActEffect effect, int i) {
        boolean right = effect.model().target() == i;
        int n = effect.during().completed(right).scene().size();
        if (right || n == 0) {
            return Simplex.uniform(n);
        }
        boolean shifted = n < effect.during().scene().size() && i > effect.model().target();
        return Simplex.vertex(n, shifted ? i - 1 : i);
    }

    @Override
    public EnvironmentOutcome sample(State s, Action a) {
        return sample(s, a, random, random);
    }

    /**
     * A next state.
     *
     * @param nature draws what the human wants, and whether an increment advances
     * @param human draws whether they answer
     */
    public EnvironmentOutcome sample(State s, Action a, RandomGenerator nature, RandomGenerator human) {
        HandoverState state = (HandoverState) s;
        if (state.task().done()) {
            return new EnvironmentOutcome(s, a, s, 0, true);
        }
        return result(s, a, draw(state, (Act) a, nature, human));
    }

    Outcome draw(HandoverState s, Act act, RandomGenerator nature, RandomGenerator human) {
        Reaction r = Reaction.to(s, act);
        ActModel percept = perceived(s.task().scene().percepts(r.effect.model()), human);
        r = r.perceived(s, percept);
        double[] h = domain.understood(percept, s.human());
        int i = Simplex.sample(moved(s), h.length, nature);
        if (r.effect.stalled() != null && nature.nextDouble() >= r.effect.advance()) {
            r = r.stalled();
        }
        if (!r.effect.completes()) {
            return answered(r, i, h, HumanModel.answer(r.seen, i, human.nextDouble()), 1);
        }
        double[] wishes = wishesAfter(r.effect, i);
        return completed(r, i, h, Simplex.sample(wishes, wishes.length, nature), 1);
    }

    /** Draws nothing if only one act can be perceived. */
    private static ActModel perceived(List<Percept> percepts, RandomGenerator human) {
        if (percepts.size() == 1) {
            return percepts.get(0).act();
        }
        double[] p = percepts.stream().mapToDouble(Percept::probability).toArray();
        return percepts.get(Simplex.sample(p, p.length, human)).act();
    }

    @Override
    public boolean terminal(State s) {
        return ((HandoverState) s).task().done();
    }
}
