package handover.tabular;

import handover.math.Simplex;
import handover.solver.BeliefMdp;
import java.util.random.RandomGenerator;

/** The belief MDP of a tabular POMDP, for sparse sampling. Used by one thread at a time. */
public final class TabularSearch implements BeliefMdp<TabularSearch.Node> {
    private final TabularPomdp m;
    private final Alphas leaves;

    /** A belief, or what is believed between an act and its observation. */
    public static final class Node {
        private final double[] b;
        /** Of what is believed before its observation. */
        private int act;

        private Node(int states) {
            b = new double[states];
        }
    }

    /** With leaves that are worth 0. */
    public TabularSearch(TabularPomdp m) {
        this(m, new Alphas(m.states().size()));
    }

    /** @param leaves lower bounds on what a belief is worth; none for 0 */
    TabularSearch(TabularPomdp m, Alphas leaves) {
        this.m = m;
        this.leaves = leaves;
    }

    /** A node with a given belief over the states. */
    public Node belief(double[] b) {
        Node node = node();
        System.arraycopy(b, 0, node.b, 0, b.length);
        return node;
    }

    @Override
    public Node node() {
        return new Node(m.states().size());
    }

    @Override
    public double discount() {
        return m.discount();
    }

    @Override
    public int acts(Node node) {
        return m.over(node.b) ? 0 : m.acts().size();
    }

    @Override
    public double start(Node node, int act, Node next) {
        next.act = act;
        m.predict(node.b, act, next.b);
        return TabularPomdp.dot(node.b, m.reward, act * node.b.length);
    }

    @Override
    public int outcomes(Node predicted) {
        return 1;
    }

    @Override
    public double outcome(Node predicted, int k, Node next) {
        next.act = predicted.act;
        System.arraycopy(predicted.b, 0, next.b, 0, next.b.length);
        return 1;
    }

    @Override
    public boolean sampled(Node outcome) {
        return true;
    }

    @Override
    public void sample(Node outcome, double stratum, RandomGenerator random, Node next) {
        int s = Simplex.quantile(outcome.b, outcome.b.length, stratum);
        m.correct(outcome.b, outcome.act, m.observed(outcome.act, s, random.nextDouble()), next.b);
    }

    @Override
    public double leaf(Node predicted) {
        return leaves.size() == 0 ? 0 : leaves.value(predicted.b);
    }
}
