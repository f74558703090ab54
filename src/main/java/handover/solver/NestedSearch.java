package handover.solver;

import handover.belief.HandoverBelief;
import handover.belief.Mind;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Percept;
import handover.domain.PerceptionParameters;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.Words;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * The belief MDP of a handover domain in which acts may be misperceived (docs/theory.md, 9): what is wanted and the human's
 * mind are believed together. A node is that of {@link HandoverSearch} with b whatever the mind, and a row of probabilities
 * for each mind. Draws the same numbers in the same order as the plain search, so that with one mind it is the plain search.
 * Leaves are worth what they are for a human who believes E[beta] (approximate). Used by one thread at a time.
 */
final class NestedSearch implements BeliefSearch<NestedSearch.Node> {
    /** The filter keeps so many times the minds that a search starts from: each act ahead multiplies them. */
    private static final int FEWER = 6;

    private final HandoverSearch plain;
    private final int limit;
    private final double[] vertex;

    /** With how many minds a search starts, near ones put together: 8 where the filter keeps 50. */
    static int minds(PerceptionParameters perception) {
        return Math.max(1, perception.minds() / FEWER);
    }

    /** @param limit minds to start from, at least 1 */
    NestedSearch(HandoverSearch plain, int limit) {
        this.plain = plain;
        this.limit = limit;
        this.vertex = new double[plain.node().own.p.length];
    }

    /** A belief over the wanted object and the mind. */
    final class Node {
        final HandoverSearch.Node plain = NestedSearch.this.plain.node();
        private int count;
        private Task[] tasks = new Task[0];
        private ActEffect[] seen = new ActEffect[0];
        /** p(wanted = i, mind), one row per mind. */
        private double[][] p = new double[0][];
        private double[] total = new double[0];
        private double[][] rates = new double[0][];
        private double[][] human = new double[0][];
        private final double[] mean = new double[plain.own.p.length];
        private final Understandings own = new Understandings(domain());
        /** beta' after each act; shared by all observations of the act that leads here. */
        private Understandings understandings = own;

        private void reserve(int size) {
            int old = p.length;
            if (size > old) {
                tasks = Arrays.copyOf(tasks, size);
                seen = Arrays.copyOf(seen, size);
                p = Arrays.copyOf(p, size);
                total = Arrays.copyOf(total, size);
                human = Arrays.copyOf(human, size);
                rates = Arrays.copyOf(rates, size);
                for (int k = old; k < size; k++) {
                    p[k] = new double[plain.own.p.length];
                    rates[k] = new double[plain.own.p.length];
                }
            }
        }

        private void set(int k, Task task, double[] beta, double[] row) {
            tasks[k] = task;
            human[k] = beta;
            System.arraycopy(row, 0, p[k], 0, plain.n);
            total[k] = Simplex.sum(row, plain.n);
        }
    }

    @Override
    public Node node() {
        return new Node();
    }

    @Override
    public void load(Node node, HandoverBelief belief) {
        plain.load(node.plain, belief);
        List<Mind> minds = belief.minds(limit);
        node.reserve(minds.size());
        node.count = minds.size();
        for (int k = 0; k < node.count; k++) {
            Mind m = minds.get(k);
            double[] row = node.count == 1 ? belief.probabilities() : Arrays.stream(m.log()).map(Math::exp).toArray();
            node.set(k, m.task(), m.human(), row);
        }
        node.understandings = node.own;
        node.own.reset();
    }

    @Override
    public NestedSearch another() {
        return new NestedSearch(plain.another(), limit);
    }

    @Override
    public double discount() {
        return plain.discount();
    }

    @Override
    public int acts(Node node) {
        return plain.acts(node.plain);
    }

    @Override
    public double start(Node node, int act, Node next) {
        ActEffect effect = node.plain.task.effect(act);
        List<Percept> percepts = node.plain.task.scene().percepts(effect.model());
        double reward = plain.begin(node.plain, effect, next.plain);
        next.reserve(node.count * percepts.size());
        next.count = 0;
        double match = 0;
        for (int k = 0; k < node.count; k++) {
            if (node.total[k] > 0) {
                reward += node.total[k] * node.tasks[k].effect(act).reward();
                for (Percept percept : percepts) {
                    match += percept.probability() * perceive(node, k, percept, next);
                }
            }
        }
        next.plain.match = match;
        return reward + match;
    }

    /** Adds a mind that perceived an act; gives what is paid for it, times its probability before the act. */
    private double perceive(Node node, int k, Percept percept, Node next) {
        int n = node.plain.n;
        int j = next.count++;
        Understandings.Entry u = node.understandings.after(k, percept.act(), node.human[k]);
        next.seen[j] = node.tasks[k].effect(percept.act().index());
        double[] row = next.p[j];
        next.set(j, next.seen[j].during(), u.human, node.p[k]);
        move(row, node.total[k], n);
        double match = domain().beliefDependentReward() ? node.total[k] * domain().matchReward(next.plain.b.p, u.human, n)
                : u.score(domain(), row, n, vertex);
        for (int i = 0; i < n; i++) {
            row[i] *= percept.probability();
        }
        next.total[j] = node.total[k] * percept.probability();
        return match;
    }

    /** The wish may move: on a row (modified) with this sum. */
    private void move(double[] row, double sum, int n) {
        double tau = domain().spec().tau();
        if (tau == 1) {
            return;
        }
        for (int i = 0; i < n; i++) {
            row[i] /= sum;
        }
        Simplex.propagate(tau, row, row, n);
        for (int i = 0; i < n; i++) {
            row[i] *= sum;
        }
    }

    @Override
    public int outcomes(Node predicted) {
        return plain.outcomes(predicted.plain);
    }

    @Override
    public double outcome(Node predicted, int k, Node next) {
        double p = plain.outcome(predicted.plain, k, next.plain);
        HandoverSearch.Node at = next.plain;
        if (!at.answerable) {
            next.reserve(1);
            next.count = 1;
            if (p > 0 && !at.task.done()) {
                next.set(0, at.task, at.h, at.b.p);
            }
        } else {
            copy(predicted, at.effect != predicted.plain.effect, next);
        }
        next.understandings = next.own;
        next.own.reset();
        return p;
    }

    private static void copy(Node from, boolean stalled, Node to) {
        to.reserve(from.count);
        to.count = from.count;
        for (int k = 0; k < from.count; k++) {
            to.seen[k] = stalled ? from.seen[k].stalled() : from.seen[k];
            to.set(k, to.seen[k].during(), from.human[k], from.p[k]);
        }
    }

    @Override
    public boolean sampled(Node outcome) {
        for (int k = 0; k < outcome.count; k++) {
            for (int i = 0; i < outcome.plain.n; i++) {
                outcome.rates[k][i] = domain().contentRate(outcome.plain.effect.model().type(), outcome.human[k][i]);
            }
        }
        return true;
    }

    /** In the order of {@link HandoverSearch#sample}; the mind comes from what the stratum leaves over. */
    @Override
    public void sample(Node outcome, double stratum, RandomGenerator random, Node next) {
        HandoverSearch.Node at = outcome.plain;
        int n = at.n;
        int i = Simplex.quantile(at.b.p, n, stratum);
        int mind = mind(outcome, i, stratum - Simplex.sum(at.b.p, i));
        next.reserve(outcome.count);
        next.count = outcome.count;
        next.plain.n = n;
        next.plain.table = at.table;
        next.plain.effect = at.effect;
        next.understandings = outcome.understandings;
        for (int k = 0; k < outcome.count; k++) {
            next.set(k, outcome.tasks[k], outcome.human[k], outcome.p[k]);
        }
        answer(outcome, mind, i, random.nextDouble(), next);
        double which = random.nextDouble();
        if (random.nextDouble() < at.effect.model().type().parameters().gestureRate()) {
            double[] gesture = at.table.evidence().gesture(i, which);
            for (int k = 0; k < next.count; k++) {
                multiply(next.p[k], gesture, n);
            }
        }
        speech(outcome, mind, i, random, next);
        normalise(next);
    }

    /** The mind at a level, up to b(i), of the minds with which object {@code i} is wanted. */
    private static int mind(Node outcome, int i, double level) {
        double left = level;
        int last = 0;
        for (int k = 0; k < outcome.count; k++) {
            if (outcome.p[k][i] > 0) {
                last = k;
                left -= outcome.p[k][i];
                if (left < 0) {
                    return k;
                }
            }
        }
        return last;
    }

    private static void answer(Node outcome, int mind, int i, double u, Node next) {
        next.plain.task = outcome.plain.task;
        if (!outcome.plain.answerable) {
            return;
        }
        Answer answer = HumanModel.answer(outcome.seen[mind], i, u);
        next.plain.task = outcome.plain.task.answered(answer);
        for (int k = 0; k < next.count; k++) {
            next.tasks[k] = outcome.tasks[k].answered(answer);
            multiply(next.p[k], outcome.seen[k].answers(answer), outcome.plain.n);
        }
    }

    private void speech(Node outcome, int mind, int i, RandomGenerator random, Node next) {
        int n = outcome.plain.n;
        boolean speaks = random.nextDouble() < outcome.rates[mind][i];
        for (int k = 0; k < next.count; k++) {
            for (int j = 0; j < n; j++) {
                next.p[k][j] *= speaks ? outcome.rates[k][j] : 1 - outcome.rates[k][j];
            }
        }
        for (int left = speaks ? HumanModel.sampleWordCount(domain(), random) : 0; left > 0; left--) {
            int word = words(outcome, mind).sample(i, random);
            for (int k = 0; k < next.count; k++) {
                multiply(next.p[k], words(outcome, k).probabilities(word), n);
            }
        }
    }

    private static Words words(Node outcome, int mind) {
        ActModel reference = outcome.plain.answerable ? outcome.seen[mind].reference() : null;
        return outcome.plain.task.scene().words(reference);
    }

    private static void multiply(double[] row, double[] likelihood, int n) {
        for (int j = 0; j < n; j++) {
            row[j] *= likelihood[j];
        }
    }

    private static void normalise(Node node) {
        int n = node.plain.n;
        double z = 0;
        for (int k = 0; k < node.count; k++) {
            node.total[k] = Simplex.sum(node.p[k], n);
            z += node.total[k];
        }
        double[] b = node.plain.own.p;
        Arrays.fill(b, 0);
        for (int k = 0; k < node.count; k++) {
            node.total[k] /= z;
            for (int i = 0; i < n; i++) {
                node.p[k][i] /= z;
                b[i] += node.p[k][i];
            }
        }
        node.plain.b = node.plain.own.begin(b, n);
    }

    @Override
    public double relevance(Node node, int act) {
        return plain.relevance(node.plain, act);
    }

    @Override
    public double leaf(Node predicted) {
        HandoverSearch.Node at = predicted.plain;
        if (predicted.count == 1) {
            at.h = predicted.human[0];
        } else {
            at.h = predicted.mean;
            Arrays.fill(at.h, 0);
            for (int k = 0; k < predicted.count; k++) {
                for (int i = 0; i < at.n; i++) {
                    at.h[i] += predicted.total[k] * predicted.human[k][i];
                }
            }
        }
        return plain.leaf(at);
    }

    private HandoverDomain domain() {
        return plain.domain();
    }
}
