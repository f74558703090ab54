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

    /** All outcomes of positive probability; throws {@link IllegalArgumentException} if the act is not legal. */
    @Override
    public List<TransitionProb> transitions(State s, Action a) {
        HandoverState state = (HandoverState) s;
        if (state.task().done()) {
            return List.of(new TransitionProb(1, new EnvironmentOutcome(s, a, s, 0, true)));
        }
        ActEffect effect = state.task().effect((Act) a);
        double[] human = domain.understood(effect.model(), state.human());
        int n = human.length;
        double[] wanted = Simplex.vertex(n, state.wanted());
        Simplex.propagate(domain.spec().tau(), wanted, wanted, n);
        List<TransitionProb> all = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            if (wanted[i] > 0) {
                addOutcomes(state, a, effect, i, human, wanted[i], all);
            }
        }
        return all;
    }

    private void addOutcomes(HandoverState s, Action a, ActEffect effect, int i, double[] human, double p,
            List<TransitionProb> all) {
        if (!effect.completes()) {
            for (Answer answer : Answer.values()) {
                double q = effect.answerProbability(answer, i);
                if (q > 0) {
                    all.add(new TransitionProb(p * q, outcome(s, a, effect, i, human, answer, 0)));
                }
            }
            return;
        }
        double[] wishes = wishesAfter(effect, i);
        for (int j = 0; j < wishes.length; j++) {
            if (wishes[j] > 0) {
                all.add(new TransitionProb(p * wishes[j], outcome(s, a, effect, i, human, Answer.NONE, j)));
            }
        }
        if (wishes.length == 0) {
            all.add(new TransitionProb(p, outcome(s, a, effect, i, human, Answer.NONE, -1)));
        }
    }

    /** What follows once it is settled what the human wanted, and what they answer or, after a pick, wish next. */
    private EnvironmentOutcome outcome(HandoverState s, Action a, ActEffect effect, int wanted, double[] human,
            Answer answer, int wish) {
        int n = human.length;
        double reward = effect.reward()
                + (domain.beliefDependentReward() ? 0 : domain.matchReward(Simplex.vertex(n, wanted), human, n));
        if (!effect.completes()) {
            HandoverState next = new HandoverState(wanted, effect.during().answered(answer), human);
            return new EnvironmentOutcome(s, a, next, reward, false);
        }
        boolean right = effect.model().target() == wanted;
        Task task = effect.during().completed(right);
        HandoverState next = new HandoverState(wish, task, Simplex.uniform(task.scene().size()));
        return new EnvironmentOutcome(s, a, next, reward + domain.pickReward(right), task.done());
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
     * @param nature draws what the human wants
     * @param human draws whether they answer
     */
    public EnvironmentOutcome sample(State s, Action a, RandomGenerator nature, RandomGenerator human) {
        HandoverState state = (HandoverState) s;
        if (state.task().done()) {
            return new EnvironmentOutcome(s, a, s, 0, true);
        }
        ActEffect effect = state.task().effect((Act) a);
        double[] h = domain.understood(effect.model(), state.human());
        int n = h.length;
        double[] wanted = Simplex.vertex(n, state.wanted());
        Simplex.propagate(domain.spec().tau(), wanted, wanted, n);
        int i = Simplex.sample(wanted, n, nature);
        if (!effect.completes()) {
            return outcome(state, a, effect, i, h, HumanModel.answer(effect, i, human.nextDouble()), 0);
        }
        double[] wishes = wishesAfter(effect, i);
        return outcome(state, a, effect, i, h, Answer.NONE, Simplex.sample(wishes, wishes.length, nature));
    }

    @Override
    public boolean terminal(State s) {
        return ((HandoverState) s).task().done();
    }
}
