package handover.contract;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.behavior.singleagent.Episode;
import burlap.behavior.singleagent.pomdp.BeliefPolicyAgent;
import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import burlap.mdp.singleagent.model.TransitionProb;
import burlap.mdp.singleagent.pomdp.SimulatedPOEnvironment;
import handover.belief.HandoverBelief;
import handover.belief.HandoverBeliefUpdate;
import handover.domain.Act;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.solver.BurlapPlanner;
import handover.solver.Deadline;
import handover.solver.HandoverSearch;
import handover.solver.Poss;
import handover.solver.SparseSampling;
import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;

/** Rules that hold the variant, the filter and the search together. */
final class BeliefRules {
    private static final int EPISODES = 6;
    private static final int STEPS = 8;
    private static final double ROUNDING = 1e-9;

    private BeliefRules() {}

    static void filter(Walk walk) {
        for (int e = 0; e < EPISODES; e++) {
            State s = walk.start();
            HandoverBelief belief = HandoverBelief.initial(walk.domain);
            Map<State, Double> states = states(belief);
            Action act = null;
            for (int k = 0; k < STEPS && !walk.model.terminal(s); k++) {
                act = walk.choose(s, act);
                EnvironmentOutcome outcome = walk.model.sample(s, act);
                State o = walk.senses.sample(outcome.op, act);
                belief = belief.after((Act) act).given((Observation) o);
                states = bayes(walk, states, act, o);
                assertAgree(belief, states, "after " + act + " and " + o + " in " + Walk.line(s));
                s = outcome.op;
            }
        }
    }

    private static Map<State, Double> states(HandoverBelief belief) {
        Map<State, Double> all = new HashMap<>();
        belief.nonZeroBeliefs().forEach(b -> belief.domain().hidden((HandoverState) b.s)
                .forEach((hidden, p) -> all.merge(hidden, p * b.belief, Double::sum)));
        return all;
    }

    private static Map<State, Double> bayes(Walk walk, Map<State, Double> before, Action act, State o) {
        Map<State, Double> after = new HashMap<>();
        before.forEach((s, p) -> {
            for (TransitionProb t : walk.model.transitions(s, act)) {
                double joint = p * t.p * walk.senses.probability(o, t.eo.op, act);
                if (joint > 0) {
                    after.merge(t.eo.op, joint, Double::sum);
                }
            }
        });
        double z = after.values().stream().mapToDouble(p -> p).sum();
        after.replaceAll((s, p) -> p / z);
        return after;
    }

    private static void assertAgree(HandoverBelief belief, Map<State, Double> states, String when) {
        double[] wanted = new double[belief.probabilities().length];
        states.forEach((s, p) -> {
            HandoverState base = Walk.base(s);
            assertEquals(belief.task(), base.task(), "what is known " + when);
            if (base.wanted() >= 0) {
                wanted[base.wanted()] += p;
            }
        });
        for (int i = 0; i < wanted.length; i++) {
            assertEquals(wanted[i], belief.probabilities()[i], ROUNDING, "belief in "
                    + belief.scene().objects().get(i).name() + " " + when);
        }
    }

    /** One act ahead without leaves, POSS gives exactly the expected reward. */
    static void rewards(Walk walk) {
        if (walk.domain.beliefDependentReward()) {
            return;
        }
        for (int e = 0; e < EPISODES / 2; e++) {
            State s = walk.start();
            HandoverBelief belief = HandoverBelief.initial(walk.domain);
            Action act = null;
            for (int k = 0; k < STEPS && !belief.task().done(); k++) {
                assertRewards(walk, belief);
                act = walk.choose(s, act);
                s = walk.model.sample(s, act).op;
                belief = belief.after((Act) act).given((Observation) walk.senses.sample(s, act));
            }
        }
    }

    private static void assertRewards(Walk walk, HandoverBelief belief) {
        Map<Act, Double> values = new Poss(1, 1, false).solve(walk.domain, new SplittableRandom(1))
                .decide(belief, Deadline.NONE, new SplittableRandom(1)).values();
        for (Action act : walk.legal(belief)) {
            double expected = 0;
            for (Map.Entry<State, Double> e : states(belief).entrySet()) {
                for (TransitionProb t : walk.model.transitions(e.getKey(), act)) {
                    expected += e.getValue() * t.p * t.eo.r;
                }
            }
            assertEquals(expected, values.get((Act) act), ROUNDING, "reward of " + act + " at " + belief + ", " + belief.task());
        }
    }

    /** Three acts ahead with few samples, the values are the same to the last bit with and without bounds. */
    static void pruning(Walk walk) {
        State s = walk.start();
        HandoverBelief belief = HandoverBelief.initial(walk.domain);
        Action act = null;
        for (int k = 0; k < STEPS && !belief.task().done(); k++) {
            HandoverSearch mdp = new HandoverSearch(belief.scene());
            double[] pruned = new double[belief.scene().acts().size()];
            double[] whole = pruned.clone();
            new SparseSampling<>(mdp, 1, true).values(mdp.root(belief), 3, 11, Deadline.NONE, pruned);
            new SparseSampling<>(new Unbounded<>(mdp), 1, true).values(mdp.root(belief), 3, 11, Deadline.NONE, whole);
            for (int a = 0; a < whole.length; a++) {
                assertEquals(whole[a], pruned[a], 0, "value of " + belief.scene().acts().get(a) + " at " + belief + ", " + belief.task());
            }
            act = walk.choose(s, act);
            s = walk.model.sample(s, act).op;
            belief = belief.after((Act) act).given((Observation) walk.senses.sample(s, act));
        }
    }

    static void burlap(Walk walk) {
        State start = walk.start();
        SimulatedPOEnvironment environment = new SimulatedPOEnvironment(walk.burlap, start);
        BurlapPlanner planner = new BurlapPlanner(walk.domain, walk.burlap, new Poss(1, 1, true), new SplittableRandom(3));
        HandoverBelief belief = HandoverBelief.initial(walk.domain);
        BeliefPolicyAgent agent = new BeliefPolicyAgent(walk.burlap, environment, planner.planFromState(belief));
        agent.setUpdater(new HandoverBeliefUpdate());
        agent.setBeliefState(belief);
        Episode episode = agent.actUntilTerminalOrMaxSteps(100);
        assertTrue(episode.numActions() > 0, "the agent did nothing from " + Walk.line(start));
        assertTrue(episode.rewardSequence.stream().allMatch(Double::isFinite), "rewards " + episode.rewardSequence + " of " + episode.actionSequence + " from " + Walk.line(start));
    }
}
