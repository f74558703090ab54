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
        ActEffect effect = s.task().effect(act);
        double[] human = domain.understood(effect.model(), s.human());
        double[] wanted = moved(s);
        List<Outcome> all = new ArrayList<>();
        for (int i = 0; i < wanted.length; i++) {
            if (wanted[i] > 0) {
                addOutcomes(effect, i, human, wanted[i] * effect.advance(), all);
                if (effect.stalled() != null) {
                    addOutcomes(effect.stalled(), i, human, wanted[i] * (1 - effect.advance()), all);
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

    private void addOutcomes(ActEffect effect, int i, double[] human, double p, List<Outcome> all) {
        if (!effect.completes()) {
            for (Answer answer : Answer.values()) {
                double q = effect.answers(answer)[i];
                if (q > 0) {
                    all.add(answered(effect, i, human, answer, p * q));
                }
            }
            return;
        }
        double[] wishes = wishesAfter(effect, i);
        for (int j = 0; j < wishes.length; j++) {
            if (wishes[j] > 0) {
                all.add(completed(effect, i, human, j, p * wishes[j]));
            }
        }
        if (wishes.length == 0) {
            all.add(completed(effect, i, human, -1, p));
        }
    }

    private static Outcome answered(ActEffect effect, int wanted, double[] human, Answer answer, double p) {
        HandoverState next = new HandoverState(wanted, effect.during().answered(answer), human);
        return new Outcome(p, wanted, human, next, effect.reward());
    }

    private Outcome completed(ActEffect effect, int wanted, double[] human, int wish, double p) {
        boolean right = effect.model().target() == wanted;
        Task task = effect.during().completed(right);
        HandoverState next = new HandoverState(wish, task, Simplex.uniform(task.scene().size()));
        return new Outcome(p, wanted, human, next, effect.reward() + domain.pickReward(right));
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
        ActEffect effect = s.task().effect(act);
        double[] h = domain.understood(effect.model(), s.human());
        int i = Simplex.sample(moved(s), h.length, nature);
        if (effect.stalled() != null && nature.nextDouble() >= effect.advance()) {
            effect = effect.stalled();
        }
        if (!effect.completes()) {
            return answered(effect, i, h, HumanModel.answer(effect, i, human.nextDouble()), 1);
        }
        double[] wishes = wishesAfter(effect, i);
        return completed(effect, i, h, Simplex.sample(wishes, wishes.length, nature), 1);
    }

    @Override
    public boolean terminal(State s) {
        return ((HandoverState) s).task().done();
    }
}
