package handover.tabular;

import handover.math.Simplex;
import handover.solver.BeliefMdp;
import java.util.random.RandomGenerator;

/** The belief MDP of a tabular POMDP, for sparse sampling. Used by one thread at a time. */
public final class TabularSearch implements BeliefMdp<TabularSearch.Node> {
    private final TabularPomdp m;
    private final boolean exact;
    private final Alphas leaves;

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
     * With leaves that are worth 0.
     *
     * @param exact whether all observations are weighed, or sampled
     */
    public TabularSearch(TabularPomdp m, boolean exact) {
        this(m, exact, new Alphas(m.states().size()));
    }

    /** @param leaves lower bounds on what a belief is worth; none for 0 */
    TabularSearch(TabularPomdp m, boolean exact, Alphas leaves) {
        this.m = m;
        this.exact = exact;
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
        next.observed = false;
        m.predict(node.b, act, next.b);
        return TabularPomdp.dot(node.b, m.reward, act * node.b.length);
    }

    @Override
    public int outcomes(Node predicted) {
        return exact ? m.observations().size() : 1;
    }

    @Override
    public double outcome(Node predicted, int k, Node next) {
        next.act = predicted.act;
        next.observed = exact;
        System.arraycopy(predicted.b, 0, next.b, 0, next.b.length);
        return exact ? m.correct(next.b, predicted.act, k) : 1;
    }

    @Override
    public boolean sampled(Node outcome) {
        return !outcome.observed;
    }

    @Override
    public void sample(Node outcome, double stratum, RandomGenerator random, Node next) {
        int s = Simplex.quantile(outcome.b, outcome.b.length, stratum);
        double u = random.nextDouble();
        int last = m.observations().size() - 1;
        int o = 0;
        while (o < last && (u -= m.observation(outcome.act, s, o)) >= 0) {
            o++;
        }
        next.act = outcome.act;
        next.observed = true;
        System.arraycopy(outcome.b, 0, next.b, 0, next.b.length);
        m.correct(next.b, outcome.act, o);
    }

    @Override
    public double leaf(Node predicted) {
        return leaves.size() == 0 ? 0 : leaves.value(predicted.b);
    }
}
