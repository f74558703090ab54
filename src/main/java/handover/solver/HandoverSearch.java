package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.Words;
import handover.math.Simplex;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import java.util.random.RandomGenerator;

/**
 * The belief MDP of a handover domain on reused arrays. Rewards may depend on the belief; the outcomes of a pick are
 * enumerated, speech and gestures are sampled. Everything that is added up here comes from the seams of the domain. Used by
 * one thread at a time.
 */
public final class HandoverSearch implements BeliefSearch<HandoverSearch.Node> {
    private final Scene largest;
    private final HandoverDomain domain;
    private final int capacity;
    private final int actCapacity;
    /** Whether what is wanted may change while the robot acts; the bounds then do not hold. */
    private final boolean moves;
    private final ConcurrentMap<Scene, Evidence> evidence;
    private final Map<Scene, AtTable> tables = new HashMap<>();

    /**
     * What is the same for all beliefs at a table.
     *
     * @param uniform what the human expects when a wish is new
     * @param leaves what leaves are worth
     */
    record AtTable(Evidence evidence, double[] uniform, CommitOrWait leaves, LastLevel last) {}

    /**
     * For beliefs over at most the objects of {@code largest}.
     *
     * @param evidence cache that searches on any thread may share
     */
    HandoverSearch(Scene largest, ConcurrentMap<Scene, Evidence> evidence) {
        this.largest = largest;
        this.evidence = evidence;
        this.domain = largest.domain();
        this.capacity = largest.size();
        this.moves = domain.spec().tau() < 1;
        this.actCapacity = largest.acts().size();
    }

    /** A search by itself, for beliefs over at most the objects of {@code largest}. */
    public HandoverSearch(Scene largest) {
        this(largest, new ConcurrentHashMap<>());
    }

    /** A node that holds a belief. */
    public Node root(HandoverBelief belief) {
        return node().load(belief);
    }

    @Override
    public void load(Node node, HandoverBelief belief) {
        node.load(belief);
    }

    /** A belief with its known part; between act and observation also what is under way. */
    public final class Node {
        /** {@link #own} or, where nothing was observed, another node's. */
        SearchBelief b;
        double[] h;
        int n;
        Task task;
        AtTable table;
        /** The act that leads here and may still be answered; null at the root. */
        ActEffect effect;
        /** The match reward of the act under way. */
        double match;
        /** Whether people may still answer: not once a pick completed. */
        boolean answerable;
        final SearchBelief own = new SearchBelief(capacity);
        /** P(content words | i) of the step that leads here, once {@link #sampled} was asked. */
        private final double[] rates = new double[capacity];
        private final Expectations ownExpectations = new Expectations(domain, capacity, actCapacity);
        /** h' after each act; shared by all observations of the act that leads here. */
        private Expectations expectations = ownExpectations;

        /** U(h, act), computed once per h. */
        double[] after(ActModel act) {
            return expectations.after(act, h);
        }

        Node load(HandoverBelief belief) {
            n = belief.probabilities().length;
            b = own.begin(belief.probabilities(), n);
            h = belief.human();
            task = belief.task();
            table = table(task.scene());
            expectations = ownExpectations;
            expectations.reset();
            return this;
        }
    }

    @Override
    public Node node() {
        return new Node();
    }

    @Override
    public double discount() {
        return domain.discount();
    }

    @Override
    public HandoverSearch another() {
        return new HandoverSearch(largest, evidence);
    }

    HandoverDomain domain() {
        return domain;
    }

    @Override
    public int acts(Node node) {
        return node.task.done() ? 0 : node.task.scene().acts().size();
    }

    @Override
    public double start(Node node, int act, Node next) {
        ActEffect effect = node.task.effect(act);
        double pick = begin(node, effect, next);
        next.h = node.after(effect.model());
        next.match = domain.matchReward(next.b.p, next.h, node.n);
        return effect.reward() + next.match + pick;
    }

    /** The same where the match reward is known already and what is wanted does not change. */
    double start(Node node, ActEffect effect, double match, Node next) {
        double pick = begin(node, effect, next);
        next.h = node.after(effect.model());
        next.match = match;
        return effect.reward() + match + pick;
    }

    /** Predicts all but h'; gives the expected reward of a pick that completes. */
    double begin(Node node, ActEffect effect, Node next) {
        next.n = node.n;
        next.task = effect.during();
        next.table = node.table;
        next.effect = effect;
        next.b = predicted(node, next.own);
        next.answerable = !effect.completes();
        return effect.completes() ? effect.advance() * domain.expectedPickReward(next.b.p[effect.model().target()]) : 0;
    }

    /** b after the transition of omega; without one, the node's own. */
    private SearchBelief predicted(Node node, SearchBelief out) {
        double tau = domain.spec().tau();
        if (tau == 1) {
            return node.b;
        }
        out.begin(node.b.p, node.n);
        Simplex.propagate(tau, out.p, out.p, node.n);
        return out;
    }

    @Override
    public int outcomes(Node predicted) {
        return (predicted.effect.completes() ? 2 : 1) + (predicted.effect.stalled() == null ? 0 : 1);
    }

    /** In this order: what happens if the act works out (where a pick completes: accepted, rejected), then if it stalls. */
    @Override
    public double outcome(Node predicted, int k, Node next) {
        ActEffect effect = predicted.effect;
        next.effect = effect;
        next.answerable = predicted.answerable;
        next.n = predicted.n;
        next.task = predicted.task;
        next.table = predicted.table;
        next.h = predicted.h;
        next.b = predicted.b;
        double p = effect.advance();
        if (effect.stalled() != null && k == outcomes(predicted) - 1) {
            next.effect = effect.stalled();
            next.task = next.effect.during();
            next.answerable = true;
            p = 1 - effect.advance();
        } else if (effect.completes()) {
            double right = Math.min(1, predicted.b.p[effect.model().target()]);
            p *= k == 0 ? right : 1 - right;
            if (p > 0) {
                complete(predicted, k == 0, next);
            }
        }
        next.expectations = next.ownExpectations;
        next.expectations.reset();
        return p;
    }

    private void complete(Node predicted, boolean right, Node next) {
        int x = predicted.effect.model().target();
        next.task = predicted.task.completed(right);
        next.n = next.task.scene().size();
        if (next.task.done()) {
            return;
        }
        next.table = table(next.task.scene());
        double[] uniform = next.table.uniform();
        next.h = uniform;
        next.b = next.own.begin(uniform, next.n);
        if (!right) {
            exclude(x, predicted.b.p, predicted.n, next.b.p, next.n);
        }
    }

    /** b once {@code x} is known not to be wanted; where nothing else was thought possible, {@code out} stays as it is. */
    private static void exclude(int x, double[] b, int n, double[] out, int outSize) {
        double others = 0;
        for (int i = 0; i < n; i++) {
            others += i == x ? 0 : b[i];
        }
        for (int i = 0, j = 0; i < n && others > 0; i++) {
            if (i != x || outSize == n) {
                out[j++] = i == x ? 0 : b[i] / others;
            }
        }
    }

    @Override
    public boolean sampled(Node outcome) {
        for (int i = 0; i < outcome.n; i++) {
            outcome.rates[i] = domain.contentRate(outcome.effect.model().type(), outcome.h[i]);
        }
        return true;
    }

    /** Draws in the same order whatever the act, so that equal seeds mean equal luck for all of them. */
    @Override
    public void sample(Node outcome, double stratum, RandomGenerator random, Node next) {
        int n = outcome.n;
        int i = Simplex.quantile(outcome.b.p, n, stratum);
        next.b = next.own.begin(outcome.b.p, n);
        double[] b = next.b.p;
        next.n = n;
        next.h = outcome.h;
        next.table = outcome.table;
        next.expectations = outcome.expectations;
        next.effect = outcome.effect;
        next.task = answer(outcome, i, random.nextDouble(), b);
        double which = random.nextDouble();
        if (random.nextDouble() < outcome.effect.model().type().parameters().gestureRate()) {
            multiply(b, outcome.table.evidence().gesture(i, which), n);
        }
        speech(outcome, i, random, b);
        Simplex.normalise(b, n);
    }

    /** The answer at level {@code u} of its distribution: corrects b (modified) by it and gives the task after it. */
    private static Task answer(Node outcome, int i, double u, double[] b) {
        if (!outcome.answerable) {
            return outcome.task;
        }
        ActEffect effect = outcome.effect;
        Answer answer = HumanModel.answer(effect, i, u);
        multiply(b, effect.answers(answer), outcome.n);
        return outcome.task.answered(answer);
    }

    /** Draws whether and which content words are said and corrects b (modified) by them. */
    private void speech(Node outcome, int i, RandomGenerator random, double[] b) {
        int n = outcome.n;
        if (random.nextDouble() >= outcome.rates[i]) {
            for (int j = 0; j < n; j++) {
                b[j] *= 1 - outcome.rates[j];
            }
            return;
        }
        multiply(b, outcome.rates, n);
        ActModel reference = outcome.answerable ? outcome.effect.reference() : null;
        Words words = outcome.task.scene().words(reference);
        for (int k = HumanModel.sampleWordCount(domain, random); k > 0; k--) {
            multiply(b, words.probabilities(words.sample(i, random)), n);
        }
    }

    private static void multiply(double[] b, double[] likelihood, int n) {
        for (int j = 0; j < n; j++) {
            b[j] *= likelihood[j];
        }
    }

    @Override
    public double leaf(Node predicted) {
        ActEffect effect = predicted.effect;
        double onward = effect.completes() ? predicted.table.leaves().afterPick(predicted) : predicted.table.leaves().value(predicted);
        if (effect.stalled() == null) {
            return onward;
        }
        predicted.task = effect.stalled().during();
        double stalled = predicted.table.leaves().value(predicted);
        predicted.task = effect.during();
        return effect.advance() * onward + (1 - effect.advance()) * stalled;
    }

    /** How likely it is that the human takes the act for a yes to their wish; a WAIT is always relevant. */
    @Override
    public double relevance(Node node, int act) {
        double[] match = node.task.effect(act).model().match();
        if (match == null) {
            return 1;
        }
        double sum = 0;
        for (int i = 0; i < node.n; i++) {
            sum += node.b.p[i] * match[i];
        }
        return sum;
    }

    @Override
    public int simple(Node node) {
        return node.table.leaves().simple(node);
    }

    @Override
    public double bound(Node node, int act) {
        return moves ? Double.POSITIVE_INFINITY : node.table.leaves().bounds().act(node.b, node.task.effect(act));
    }

    @Override
    public double last(Node node, boolean leaves, Node next) {
        return moves || !leaves ? BeliefSearch.super.last(node, leaves, next) : node.table.last().best(node, next);
    }

    private AtTable table(Scene scene) {
        return tables.computeIfAbsent(scene, s -> {
            CommitOrWait leaves = new CommitOrWait(s);
            return new AtTable(evidence.computeIfAbsent(s, Evidence::new), Simplex.uniform(s.size()), leaves, new LastLevel(this, s, leaves));
        });
    }
}
