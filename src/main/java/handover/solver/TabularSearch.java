package handover.solver;

import burlap.behavior.singleagent.auxiliary.StateEnumerator;
import burlap.mdp.core.action.Action;
import burlap.mdp.core.action.ActionUtils;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.model.TransitionProb;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.observations.DiscreteObservationFunction;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * The belief MDP of any tabular BURLAP {@link PODomain}: enumerated states, a {@link FullModel}, discrete observations, and
 * the same acts in every state. Leaves are worth 0. Used by one thread at a time.
 */
public final class TabularSearch implements BeliefMdp<TabularSearch.Node> {
    private final double discount;
    private final boolean exact;
    private final List<State> states = new ArrayList<>();
    private final List<Action> acts;
    /** By act: reward of each state. */
    private final double[][] reward;
    /** By act, state, next state. */
    private final double[][][] transition;
    /** By act, observation, next state. */
    private final double[][][] observation;
    private final boolean[] terminal;

    /** A belief, or what is believed between an act and its observation. */
    public static final class Node {
        private final double[] b;
        private int act;
        private boolean observed;

        private Node(int states) {
            b = new double[states];
        }
    }

    /**
     * @param exact whether all observations are weighed, or sampled
     * @throws IllegalArgumentException if the domain is not tabular
     */
    public TabularSearch(PODomain domain, double discount, boolean exact) {
        if (!(domain.getModel() instanceof FullModel model)
                || !(domain.getObservationFunction() instanceof DiscreteObservationFunction senses)
                || !domain.providesStateEnumerator()) {
            throw new IllegalArgumentException(
                    "expected a domain with a FullModel, a DiscreteObservationFunction and a StateEnumerator");
        }
        this.discount = discount;
        this.exact = exact;
        StateEnumerator enumerator = domain.getStateEnumerator();
        for (int s = 0; s < enumerator.numStatesEnumerated(); s++) {
            states.add(enumerator.getStateForEnumerationId(s));
        }
        int n = states.size();
        acts = ActionUtils.allApplicableActionsForTypes(domain.getActionTypes(), states.get(0));
        List<State> observations = senses.allObservations();
        reward = new double[acts.size()][n];
        transition = new double[acts.size()][n][n];
        observation = new double[acts.size()][observations.size()][n];
        terminal = new boolean[n];
        for (int s = 0; s < n; s++) {
            terminal[s] = model.terminal(states.get(s));
            for (int a = 0; a < acts.size(); a++) {
                for (TransitionProb t : model.transitions(states.get(s), acts.get(a))) {
                    reward[a][s] += t.p * t.eo.r;
                    int next = enumerator.getEnumeratedID(t.eo.op);
                    if (next >= n) {
                        throw new IllegalArgumentException("expected all reachable states to be enumerated, found another: " + t.eo.op);
                    }
                    transition[a][s][next] += t.p;
                }
                for (int o = 0; o < observations.size(); o++) {
                    observation[a][o][s] = senses.probability(observations.get(o), states.get(s), acts.get(a));
                }
            }
        }
    }

    /** The acts, in the order of the values. */
    public List<Action> acts() {
        return acts;
    }

    /** A node with a given belief over the enumerated states. */
    public Node belief(double[] b) {
        Node node = node();
        System.arraycopy(b, 0, node.b, 0, b.length);
        return node;
    }

    @Override
    public Node node() {
        return new Node(states.size());
    }

    @Override
    public double discount() {
        return discount;
    }

    @Override
    public int acts(Node node) {
        for (int s = 0; s < node.b.length; s++) {
            if (node.b[s] > 0 && !terminal[s]) {
                return acts.size();
            }
        }
        return 0;
    }

    @Override
    public double start(Node node, int act, Node next) {
        next.act = act;
        next.observed = false;
        Arrays.fill(next.b, 0);
        double r = 0;
        for (int s = 0; s < node.b.length; s++) {
            r += node.b[s] * reward[act][s];
            for (int t = 0; t < node.b.length; t++) {
                next.b[t] += node.b[s] * transition[act][s][t];
            }
        }
        return r;
    }

    @Override
    public int outcomes(Node predicted) {
        return exact ? observation[predicted.act].length : 1;
    }

    @Override
    public double outcome(Node predicted, int k, Node next) {
        next.act = predicted.act;
        next.observed = exact;
        System.arraycopy(predicted.b, 0, next.b, 0, next.b.length);
        return exact ? condition(next.b, observation[predicted.act][k]) : 1;
    }

    @Override
    public boolean sampled(Node outcome) {
        return !outcome.observed;
    }

    @Override
    public void sample(Node outcome, double stratum, RandomGenerator random, Node next) {
        int s = Simplex.quantile(outcome.b, outcome.b.length, stratum);
        double u = random.nextDouble();
        double[][] p = observation[outcome.act];
        int o = 0;
        while (o < p.length - 1 && (u -= p[o][s]) >= 0) {
            o++;
        }
        next.act = outcome.act;
        next.observed = true;
        System.arraycopy(outcome.b, 0, next.b, 0, next.b.length);
        condition(next.b, p[o]);
    }

    private static double condition(double[] b, double[] likelihood) {
        for (int s = 0; s < b.length; s++) {
            b[s] *= likelihood[s];
        }
        return Simplex.normalise(b, b.length);
    }

    @Override
    public double leaf(Node predicted) {
        return 0;
    }
}
