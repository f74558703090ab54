package handover.theory;

import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The law of beta' = l beta / (l . beta) (entry by entry) for beta ~ Dir(alpha): what Bayes' rule makes of a Dirichlet. Its
 * moments are one-dimensional integrals (MODEL 8), taken in u = log s. With r_j(u) = l_j s / (1 + l_j s) and
 * A(u) = prod_k (1 + l_k s)^-alpha_k,
 * <pre>
 *   E[beta'_j]          = alpha_j int r_j A du
 *   E[beta'_j beta'_k]  = alpha_j (alpha_k + [j=k]) int r_j r_k A du
 *   E[log beta'_j]      = log l_j + psi(alpha_j) - int (exp(-e^u) - A) du
 * </pre>
 * All integrands are analytic and bounded for |Im u| &lt; pi/2 whatever alpha, so the trapezoidal rule with step 1/4 is exact
 * to rounding (its error is of the order exp(-pi^2 / (1/4))). Below the interval A = 1; above it r = 1 or 0 and A is an exact
 * exponential, whose trapezoidal sum is a geometric series: alpha may be as small as one likes at no cost. Relative error of
 * mean and second moments below 1e-12; about 4 (78 + log alpha_0 + log(max l / min l)) steps of n exponentials and logarithms
 * at most. Immutable, thread safe.
 *
 * <p>Source: the integrals follow from 1/x = int exp(-s x) ds and gamma variates; trapezoidal rule: Trefethen and
 * Weideman, "The exponentially convergent trapezoidal rule", 2014.
 */
public final class ScaledDirichlet {
    private static final double STEP = 0.25;
    /** What is below exp(-39) = 1e-17 is left out. */
    private static final double NEGLIGIBLE = 39;

    private final double[] alpha;
    private final double[] likelihood;
    private final double[] logLikelihood;
    /** Sum of the alphas of the objects that are still possible. */
    private final double total;
    private final double scale;

    /** A point of the rule: its weight (step times A) and r_j. */
    private record Node(double weight, double[] ratio) {}

    /**
     * @param alpha n entries >= 0 (0: the object is excluded); not modified
     * @param likelihood n entries >= 0, for at least one of which alpha > 0; not modified
     * @throws IllegalArgumentException if an entry is negative or not finite, or no object is possible
     */
    public ScaledDirichlet(double[] alpha, double[] likelihood) {
        Weights.sameSize("likelihood", alpha.length, likelihood.length);
        this.alpha = Weights.checked("alpha", alpha);
        this.likelihood = Weights.checked("likelihood", likelihood);
        double sum = 0;
        double max = 0;
        for (int k = 0; k < alpha.length; k++) {
            if (alpha[k] > 0 && likelihood[k] > 0) {
                sum += alpha[k];
                max = Math.max(max, likelihood[k]);
            }
        }
        if (!(max > 0)) {
            throw new IllegalArgumentException("scaled Dirichlet: expected an object with alpha > 0 and likelihood > 0");
        }
        this.total = sum;
        this.scale = max;
        this.logLikelihood = new double[alpha.length];
        for (int k = 0; k < alpha.length; k++) {
            logLikelihood[k] = alpha[k] > 0 ? Math.log(likelihood[k] / max) : Double.NEGATIVE_INFINITY;
        }
    }

    /** E[beta'], sums to one. */
    public double[] mean() {
        double[] m = new double[alpha.length];
        for (Node node : nodes()) {
            for (int j = 0; j < m.length; j++) {
                m[j] += alpha[j] * node.weight * node.ratio[j];
            }
        }
        return m;
    }

    /** Mean and E[beta'_j^2], from one pass. */
    Moments moments() {
        double[] m = new double[alpha.length];
        double q = 0;
        for (Node node : nodes()) {
            for (int j = 0; j < m.length; j++) {
                double part = alpha[j] * node.weight * node.ratio[j];
                m[j] += part;
                q += part * (alpha[j] + 1) * node.ratio[j];
            }
        }
        return new Moments(m, q);
    }

    /** E[beta' beta'^T], n x n, whose entries sum to one. */
    public DMatrixRMaj secondMoments() {
        int n = alpha.length;
        DMatrixRMaj s = new DMatrixRMaj(n, n);
        for (Node node : nodes()) {
            DMatrixRMaj r = DMatrixRMaj.wrap(n, 1, node.ratio);
            CommonOps_DDRM.multAddTransB(node.weight, r, r, s);
        }
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < n; k++) {
                s.set(j, k, s.get(j, k) * alpha[j] * (alpha[k] + (j == k ? 1 : 0)));
            }
        }
        return s;
    }

    /** E[log beta'_j], one entry per object; -infinity for those that are excluded. */
    public double[] meanLog() {
        double left = Math.min(leftEnd(), -NEGLIGIBLE);
        double integral = 0;
        double u = left;
        double logA = logA(u);
        double knee = knee();
        while (u < knee && -logA < NEGLIGIBLE || u < Math.log(NEGLIGIBLE) + STEP) {
            integral += STEP * (Math.exp(-Math.exp(u)) - Math.exp(logA));
            u += STEP;
            logA = logA(u);
        }
        integral -= Math.exp(logA) * STEP / -Math.expm1(-total * STEP);
        double[] g = new double[alpha.length];
        for (int j = 0; j < g.length; j++) {
            g[j] = logLikelihood[j] == Double.NEGATIVE_INFINITY ? Double.NEGATIVE_INFINITY
                    : logLikelihood[j] + Digamma.of(alpha[j]) - integral;
        }
        return g;
    }

    /** The points of the rule; the last one stands for all that follow. */
    private List<Node> nodes() {
        List<Node> nodes = new ArrayList<>();
        double knee = knee();
        double u = leftEnd();
        while (true) {
            double[] ratio = new double[alpha.length];
            double logA = 0;
            for (int k = 0; k < ratio.length; k++) {
                double x = u + logLikelihood[k];
                double e = Math.exp(-Math.abs(x));
                ratio[k] = (x > 0 ? 1 : e) / (1 + e);
                logA -= alpha[k] * (Math.max(x, 0) + Math.log1p(e));
            }
            if (u >= knee) {
                nodes.add(new Node(Math.exp(logA) * STEP / -Math.expm1(-total * STEP), ratio));
                return nodes;
            }
            nodes.add(new Node(Math.exp(logA) * STEP, ratio));
            if (Math.log1p(total) - logA > NEGLIGIBLE) {
                return nodes;
            }
            u += STEP;
        }
    }

    private double logA(double u) {
        double sum = 0;
        for (int k = 0; k < alpha.length; k++) {
            double x = u + logLikelihood[k];
            sum -= alpha[k] * (Math.max(x, 0) + Math.log1p(Math.exp(-Math.abs(x))));
        }
        return sum;
    }

    /** Where 1 - A, and with it all that lies to the left, is negligible: sum_k alpha_k l_k s = exp(-39). */
    private double leftEnd() {
        double rate = 0;
        for (int k = 0; k < alpha.length; k++) {
            rate += alpha[k] * likelihood[k] / scale;
        }
        return -NEGLIGIBLE - Math.log(rate);
    }

    /** From where on 1 + l_k s = l_k s to rounding for every object that is possible. */
    private double knee() {
        double knee = 0;
        for (double x : logLikelihood) {
            knee = x > Double.NEGATIVE_INFINITY ? Math.max(knee, -x) : knee;
        }
        return knee + NEGLIGIBLE;
    }
}
