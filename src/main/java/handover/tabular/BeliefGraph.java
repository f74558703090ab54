package handover.tabular;

import java.util.Arrays;

/**
 * Beliefs that a search met, each with a bound on its value from both sides, and where the acts that were expanded lead from them.
 * Equal beliefs are one node, however they are reached ({@link BeliefStore}). Bounds from below are vectors, which hold at all beliefs;
 * bounds from above belong to nodes and reach others by {@link UpperPoints}. Both only ever close. Used by one thread; what it
 * allocates it uses again.
 *
 * <p>Source: the backups of HSVI2 (Smith and Simmons, "Point-based POMDP algorithms: improved analysis and implementation", 2005).
 */
final class BeliefGraph {
    private static final double TINY = 1e-12;

    private final TabularPomdp m;
    private final Learned learned;
    private final Clock clock;
    private final int n;
    private final int acts;
    private final int senses;
    private final BeliefStore beliefs;
    private final UpperPoints points;
    private final Alphas vectors;

    private double[] lower = new double[1024];
    private double[] upper = new double[1024];
    /** The best vector at each node, and how many of the vectors, and of the points, were compared. */
    private int[] vector = new int[1024];
    private int[] compared = new int[1024];
    private int[] projected = new int[1024];
    /** Which of the points a node is, -1 if none. */
    private int[] point = new int[1024];
    /** Which block of acts a node has, -1 if none. */
    private int[] block = new int[1024];
    private int blocks;
    /** By block and act. */
    private double[] actUpper = new double[0];
    private double[] actReward = new double[0];
    private int[] group = new int[0];
    private int groups;
    /** By group and observation: the node that it leads to, -1 if it cannot be observed, and how likely it is. */
    private int[] child = new int[0];
    private double[] weight = new double[0];

    private final double[] dense;
    private final double[] predicted;
    private final double[] posterior;
    private final double[] fresh;
    private double[] products = new double[64];

    BeliefGraph(TabularPomdp m, Learned learned, Clock clock) {
        this.m = m;
        this.learned = learned;
        this.clock = clock;
        n = m.states().size();
        acts = m.acts().size();
        senses = m.observations().size();
        beliefs = new BeliefStore(n);
        points = new UpperPoints(beliefs, learned.bounds().corners());
        vectors = learned.vectors().copy();
        dense = new double[n];
        predicted = new double[n];
        posterior = new double[n];
        fresh = new double[n];
    }

    /** Begins again with one belief and what was learnt before; gives the belief's node. */
    int reset(double[] belief) {
        beliefs.clear();
        points.clear();
        vectors.truncate(learned.vectors().size());
        blocks = 0;
        groups = 0;
        int root = node(belief);
        for (int k = 0; k < learned.size(); k++) {
            int at = node(learned.belief(k));
            upper[at] = Math.min(upper[at], learned.bound(k));
            point[at] = point[at] < 0 ? points.add(at, upper[at]) : point[at];
        }
        refresh(root);
        return root;
    }

    int size() {
        return beliefs.size();
    }

    double lower(int k) {
        return lower[k];
    }

    double upper(int k) {
        return upper[k];
    }

    Alphas vectors() {
        return vectors;
    }

    /** The act that the best vector of a node begins with. */
    int usualAct(int k) {
        return vectors.act(vector[k]);
    }

    boolean opened(int k) {
        return block[k] >= 0;
    }

    boolean expanded(int k, int a) {
        return block[k] >= 0 && group[block[k] * acts + a] >= 0;
    }

    /** The node that an observation leads to after an expanded act, -1 if it cannot be. */
    int child(int k, int a, int o) {
        return child[group[block[k] * acts + a] * senses + o];
    }

    /** The probability of an observation after an expanded act. */
    double weight(int k, int a, int o) {
        return weight[group[block[k] * acts + a] * senses + o];
    }

    private int node(double[] belief) {
        int before = beliefs.size();
        int k = beliefs.number(belief);
        if (k < before) {
            return k;
        }
        if (k == lower.length) {
            grow();
        }
        block[k] = -1;
        point[k] = -1;
        compared[k] = 0;
        projected[k] = 0;
        lower[k] = Double.NEGATIVE_INFINITY;
        compare(k);
        double u = Double.NEGATIVE_INFINITY;
        Alphas informed = learned.bounds().upper();
        for (int i = 0; i < informed.size(); i++) {
            u = Math.max(u, beliefs.dot(k, informed.values(), informed.at(i)));
        }
        upper[k] = u;
        clock.spend(n * informed.size());
        return k;
    }

    private void grow() {
        int more = 2 * lower.length;
        lower = Arrays.copyOf(lower, more);
        upper = Arrays.copyOf(upper, more);
        vector = Arrays.copyOf(vector, more);
        compared = Arrays.copyOf(compared, more);
        projected = Arrays.copyOf(projected, more);
        point = Arrays.copyOf(point, more);
        block = Arrays.copyOf(block, more);
    }

    /** Raises a lower bound by the vectors that are new since the last time. */
    private void compare(int k) {
        int first = compared[k];
        int size = vectors.size();
        if (products.length < vectors.capacity()) {
            products = new double[vectors.capacity()];
        }
        Arrays.fill(products, first, size, 0);
        for (int i = beliefs.begin(k); i < beliefs.begin(k + 1); i++) {
            vectors.accumulate(beliefs.states()[i], beliefs.probabilities()[i], first, products);
        }
        for (int i = first; i < size; i++) {
            if (products[i] > lower[k]) {
                lower[k] = products[i];
                vector[k] = i;
            }
        }
        clock.spend((size - first) * (beliefs.begin(k + 1) - beliefs.begin(k)));
        compared[k] = size;
    }

    /** Both bounds of a node by what was learnt elsewhere. */
    void refresh(int k) {
        compare(k);
        beliefs.scatter(k, dense);
        upper[k] = Math.min(upper[k], points.bound(k, dense, projected[k]));
        clock.spend((points.size() - projected[k]) * 4);
        projected[k] = points.size();
        beliefs.unscatter(k, dense);
    }

    /** Gives a node its acts, none of them expanded yet. */
    void open(int k) {
        if ((blocks + 1) * acts > group.length) {
            int more = Math.max(64 * acts, 2 * group.length);
            actUpper = Arrays.copyOf(actUpper, more);
            actReward = Arrays.copyOf(actReward, more);
            group = Arrays.copyOf(group, more);
        }
        block[k] = blocks++;
        for (int a = 0; a < acts; a++) {
            group[block[k] * acts + a] = -1;
            actUpper[block[k] * acts + a] = beliefs.dot(k, learned.bounds().fib(), a * n);
            actReward[block[k] * acts + a] = beliefs.dot(k, m.reward, a * n);
        }
        clock.spend(2 * acts * n);
    }

    /** Adds the nodes that an act of an opened node may lead to; false, with nothing added to the act, if it is late. */
    boolean expand(int k, int a) {
        if ((groups + 1) * senses > child.length) {
            int more = Math.max(64 * senses, 2 * child.length);
            child = Arrays.copyOf(child, more);
            weight = Arrays.copyOf(weight, more);
        }
        beliefs.predict(k, m, a, predicted);
        int to = groups * senses;
        for (int o = 0; o < senses && !clock.late(); o++) {
            double p = m.correct(predicted, a, o, posterior);
            weight[to + o] = p;
            child[to + o] = p > 0 ? node(posterior) : -1;
            clock.spend(2 * n);
        }
        if (clock.late()) {
            return false;
        }
        group[block[k] * acts + a] = groups++;
        raise(block[k] * acts + a);
        return true;
    }

    /** The upper bound of an expanded act from those of the nodes that it leads to. */
    private void raise(int at) {
        int from = group[at] * senses;
        double u = 0;
        for (int o = 0; o < senses; o++) {
            u += child[from + o] < 0 ? 0 : weight[from + o] * upper[child[from + o]];
        }
        actUpper[at] = Math.min(actUpper[at], actReward[at] + m.discount() * u);
    }

    private double expandedLower(int at) {
        int from = group[at] * senses;
        double v = 0;
        for (int o = 0; o < senses; o++) {
            int c = child[from + o];
            if (c >= 0) {
                compare(c);
                v += weight[from + o] * lower[c];
            }
        }
        return actReward[at] + m.discount() * v;
    }

    /** New bounds of an opened node from those of the nodes that its expanded acts lead to. */
    void backup(int k) {
        int from = block[k] * acts;
        double most = Double.NEGATIVE_INFINITY;
        compare(k);
        int best = -1;
        double value = lower[k] + TINY * Math.abs(lower[k]);
        for (int a = 0; a < acts; a++) {
            if (group[from + a] >= 0) {
                raise(from + a);
                double v = actUpper[from + a] > value ? expandedLower(from + a) : Double.NEGATIVE_INFINITY;
                best = v > value ? a : best;
                value = Math.max(value, v);
            }
            most = Math.max(most, actUpper[from + a]);
        }
        if (best >= 0) {
            addVector(group[from + best] * senses, best);
            compare(k);
        }
        if (most < upper[k]) {
            upper[k] = most;
            if (point[k] < 0) {
                point[k] = points.add(k, most);
            } else {
                points.lower(point[k], most);
            }
        }
    }

    /** The vector of doing an act and going on as is best at the nodes that it leads to from here. */
    private void addVector(int from, int a) {
        Arrays.fill(posterior, 0);
        int other = 0;
        for (int o = 0; o < senses; o++) {
            other = child[from + o] >= 0 ? vector[child[from + o]] : other;
            int at = (a * senses + o) * n;
            int v = vectors.at(other);
            for (int s = 0; s < n; s++) {
                posterior[s] += m.sensed[at + s] * vectors.values()[v + s];
            }
        }
        for (int s = 0; s < n; s++) {
            double e = 0;
            for (int j = m.row[a * n + s]; j < m.row[a * n + s + 1]; j++) {
                e += m.probability[j] * posterior[m.next[j]];
            }
            fresh[s] = m.reward[a * n + s] + m.discount() * e;
        }
        vectors.add(fresh, 0, a);
        clock.spend(senses * n);
    }

    /** A lower bound on the value of an act. */
    double actLower(int k, int a) {
        double most = expanded(k, a) ? expandedLower(block[k] * acts + a) : Double.NEGATIVE_INFINITY;
        for (int v = 0; v < vectors.size(); v++) {
            if (vectors.act(v) == a) {
                most = Math.max(most, beliefs.dot(k, vectors.values(), vectors.at(v)));
            }
        }
        return most;
    }

    /** An upper bound on the value of an act. */
    double actUpper(int k, int a) {
        return block[k] >= 0 ? actUpper[block[k] * acts + a] : beliefs.dot(k, learned.bounds().fib(), a * n);
    }

    /**
     * What can be used for other beliefs: the vectors of the model's own bound and those that are best somewhere, and the nodes with a
     * lowered upper bound.
     */
    Learned learned() {
        boolean[] used = new boolean[vectors.size()];
        for (int k = 0; k < beliefs.size(); k++) {
            if (block[k] >= 0) {
                compare(k);
                used[vector[k]] = true;
            }
        }
        Alphas kept = learned.bounds().lower().copy();
        for (int k = 0; k < used.length; k++) {
            if (used[k]) {
                kept.add(vectors.values(), vectors.at(k), vectors.act(k));
            }
        }
        double[][] where = new double[points.size()][n];
        double[] bound = new double[where.length];
        for (int i = 0; i < where.length; i++) {
            beliefs.scatter(points.node(i), where[i]);
            bound[i] = upper[points.node(i)];
        }
        return new Learned(learned.bounds(), kept.pruned(), where, bound);
    }
}
