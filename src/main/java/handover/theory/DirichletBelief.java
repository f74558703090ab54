package handover.theory;

import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.random.RandomGenerator;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * B as one Dirichlet, alpha = alpha_0 m, with its two limits: alpha_0 = infinity is certainty that beta = m, alpha_0 = 0
 * says that the other is sure of one object, of j with probability m_j. Every update forms the exact mean and second
 * moments of what the Dirichlet becomes and projects them back (MODEL 8). Immutable, thread safe; the array must not be
 * modified.
 *
 * @param mean m = E[beta], n entries, summing to one; copied
 * @param concentration alpha_0 in [0, infinity]
 * @param projection how to project
 * @param <S> who holds B
 */
public record DirichletBelief<S extends Agent<?, ?>>(double[] mean, double concentration, Projection projection)
        implements Nested<S> {
    /** A smaller concentration is none: its reciprocal would overflow. */
    private static final double SMALLEST = 1e-200;
    /** A larger one is certainty: its square would overflow, and the variance is below rounding. */
    private static final double LARGEST = 1e100;

    /** Throws {@link IllegalArgumentException} if the mean is no distribution or the concentration negative. */
    public DirichletBelief {
        mean = Weights.distribution("mean", mean);
        if (!(concentration >= 0)) {
            throw new IllegalArgumentException("concentration: expected a number >= 0 or infinity, got " + concentration);
        }
        concentration = concentration < SMALLEST ? 0
                : concentration > LARGEST ? Double.POSITIVE_INFINITY : concentration;
    }

    /** Dir(alpha). Throws {@link IllegalArgumentException} if an entry is negative or none is positive. */
    public static <S extends Agent<?, ?>> DirichletBelief<S> of(double[] alpha, Projection projection) {
        double[] m = Weights.checked("alpha", alpha);
        double total = Simplex.normalise(m, m.length);
        if (!(total > 0)) {
            throw new IllegalArgumentException("alpha: expected a positive entry, got " + Arrays.toString(alpha));
        }
        return new DirichletBelief<>(m, total, projection);
    }

    /** Certainty that the other's belief is {@code beta}. */
    public static <S extends Agent<?, ?>> DirichletBelief<S> certain(Categorical<S> beta, Projection projection) {
        return new DirichletBelief<>(beta.probabilities(), Double.POSITIVE_INFINITY, projection);
    }

    /** The Dirichlet that stands for finitely many beliefs. */
    public static <S extends Agent<?, ?>> DirichletBelief<S> project(Atoms<S> atoms, Projection projection) {
        return projected(new Moments(atoms.mean(), atoms.meanSquare()), atoms.meanLog(), projection);
    }

    /** alpha = alpha_0 m, a new array; all infinite (or zero) in the limits. */
    public double[] alpha() {
        return Arrays.stream(mean).map(m -> m == 0 ? 0 : m * concentration).toArray();
    }

    /** Whether beta is known, or is a vertex: no density to integrate over. */
    private boolean limit() {
        return concentration == 0 || concentration == Double.POSITIVE_INFINITY;
    }

    @Override
    public int size() {
        return mean.length;
    }

    @Override
    public double meanSquare() {
        double squared = new Moments(mean, 0).meanSquared();
        return squared + (1 - squared) / (concentration + 1);
    }

    /** m m^T + (diag(m) - m m^T) / (alpha_0 + 1). */
    @Override
    public DMatrixRMaj secondMoments() {
        DMatrixRMaj column = DMatrixRMaj.wrap(size(), 1, mean);
        DMatrixRMaj s = CommonOps_DDRM.diag(mean);
        CommonOps_DDRM.multAddTransB(-1, column, column, s);
        CommonOps_DDRM.scale(1 / (concentration + 1), s);
        CommonOps_DDRM.multAddTransB(column, column, s);
        return s;
    }

    /**
     * E[log beta_j] = psi(alpha_j) - psi(alpha_0), one entry per object; -infinity where an object is or may be excluded.
     */
    public double[] meanLog() {
        double[] g = new double[size()];
        for (int j = 0; j < g.length; j++) {
            double a = mean[j] * concentration;
            g[j] = mean[j] == 0 ? Double.NEGATIVE_INFINITY : mean[j] == 1 ? 0
                    : concentration == 0 ? Double.NEGATIVE_INFINITY
                    : concentration == Double.POSITIVE_INFINITY ? Math.log(mean[j])
                    : Digamma.of(a) - Digamma.of(concentration);
        }
        return g;
    }

    /** Maps the moments, m to T^T m and S to T^T S T, and projects them. */
    @Override
    public DirichletBelief<S> predicted(Transition<S> t) {
        Weights.sameSize("transition", size(), t.size());
        if (t.still()) {
            return this;
        }
        double square = CommonOps_DDRM.trace(t.moved(secondMoments()));
        return matched(new Moments(t.moved(mean), square));
    }

    /** Projects the mixture, over what may have been perceived, of the scaled Dirichlets that Bayes' rule gives. */
    @Override
    public DirichletBelief<S> perceived(Perception<S> act) {
        Weights.sameSize("perceived act", size(), act.objects());
        double[] m = new double[size()];
        double[] g = new double[size()];
        double q = 0;
        boolean changed = false;
        for (int a = 0; a < act.size(); a++) {
            double p = act.probabilities()[a];
            if (p == 0) {
                continue;
            }
            double[] likelihood = act.messages().get(a).likelihood();
            boolean says = !act.messages().get(a).uninformative() && possible(likelihood);
            changed |= says;
            Moments part = says ? corrected(likelihood) : new Moments(mean, meanSquare());
            double[] logs = projection == Projection.MOMENTS ? g : says ? correctedLog(likelihood) : meanLog();
            q += p * part.square();
            for (int j = 0; j < m.length; j++) {
                m[j] += p * part.mean()[j];
                g[j] = projection == Projection.MOMENTS ? 0 : g[j] + p * logs[j];
            }
        }
        return changed ? projected(new Moments(m, q), g, projection) : this;
    }

    private boolean possible(double[] likelihood) {
        for (int j = 0; j < mean.length; j++) {
            if ((limit() ? mean[j] : mean[j] * concentration) > 0 && likelihood[j] > 0) {
                return true;
            }
        }
        return false;
    }

    private Moments corrected(double[] likelihood) {
        if (concentration == 0) {
            return new Moments(mean, 1);
        }
        if (concentration == Double.POSITIVE_INFINITY) {
            Moments point = new Moments(Categorical.corrected(mean, likelihood), 0);
            return new Moments(point.mean(), point.meanSquared());
        }
        return new ScaledDirichlet(alpha(), likelihood).moments();
    }

    private double[] correctedLog(double[] likelihood) {
        return limit() ? new DirichletBelief<S>(corrected(likelihood).mean(), concentration, projection).meanLog()
                : new ScaledDirichlet(alpha(), likelihood).meanLog();
    }

    /**
     * The exact posterior is the mixture of Dir(alpha + e_j) with the weights w_j = l_j alpha_j / sum_k l_k alpha_k; its
     * mean is (alpha + w) / (alpha_0 + 1), and it is projected.
     */
    @Override
    public DirichletBelief<S> given(Evidence<S> evidence) {
        double z = evidence.given(mean);
        if (!(z > 0) || concentration == Double.POSITIVE_INFINITY) {
            return this;
        }
        double[] w = Categorical.corrected(mean, evidence.weights());
        double[] m = new double[size()];
        double[] g = meanLog();
        double sum = 0;
        double cross = 0;
        for (int j = 0; j < m.length; j++) {
            double a = concentration * mean[j];
            m[j] = (a + w[j]) / (concentration + 1);
            sum += a * (a + 1);
            cross += w[j] * a;
            g[j] += (a > 0 ? w[j] / a : 0) - 1 / concentration;
        }
        double q = (sum + 2 * cross + 2) / ((concentration + 1) * (concentration + 2));
        return projected(new Moments(m, q), g, projection);
    }

    @Override
    public double expected(MatchScore score, double[] b) {
        Weights.sameSize("belief", size(), b.length);
        double square = 0;
        double product = 0;
        for (int j = 0; j < b.length; j++) {
            square += b[j] * b[j];
            product += b[j] * mean[j];
        }
        return switch (score) {
            case NONE -> 0;
            case LINEAR -> product;
            case BRIER -> 2 * product - meanSquare() - 1;
            case L2 -> 2 * product - meanSquare() - square;
            default -> byEntry(score, b);
        };
    }

    /**
     * E_B[sum_j b_j log beta_j] = sum_j b_j (psi(alpha_j) - psi(alpha_0)): the log score without smoothing, at least
     * -infinity.
     */
    public double expectedLog(double[] b) {
        double[] g = meanLog();
        double s = 0;
        for (int j = 0; j < b.length; j++) {
            s += b[j] > 0 ? b[j] * g[j] : 0;
        }
        return s;
    }

    /** The scores that are sums over objects of a function of one entry of beta. */
    private double byEntry(MatchScore score, double[] b) {
        double s = 0;
        for (int j = 0; j < b.length; j++) {
            BetaMarginal marginal = new BetaMarginal(mean[j], concentration);
            double bj = b[j];
            double[] beta = new double[b.length];
            double[] vertex = Simplex.vertex(b.length, j);
            int at = j;
            s += switch (score) {
                case L1 -> -marginal.absoluteDeviation(bj);
                case JS -> marginal.expectation(x -> score.of(new double[] {bj}, new double[] {x}, 1));
                default -> bj == 0 ? 0 : bj * marginal.expectation(x -> {
                    beta[at] = x;
                    return MatchScore.LOG.of(vertex, beta, beta.length);
                }) - (score == MatchScore.KL ? bj * Math.log(bj) : 0);
            };
        }
        return s;
    }

    /** A belief drawn from B. */
    public double[] sample(RandomGenerator random) {
        if (concentration == Double.POSITIVE_INFINITY) {
            return mean.clone();
        }
        return concentration == 0 ? Simplex.vertex(size(), Simplex.sample(mean, size(), random))
                : GammaVariates.dirichlet(alpha(), random);
    }

    private DirichletBelief<S> matched(Moments moments) {
        DirichletBelief<S> next = projected(moments, null, Projection.MOMENTS);
        return new DirichletBelief<>(next.mean, next.concentration, projection);
    }

    private static <S extends Agent<?, ?>> DirichletBelief<S> projected(Moments moments, double[] meanLog, Projection p) {
        double[] m = moments.mean().clone();
        Simplex.normalise(m, m.length);
        if (p == Projection.LOG_MOMENTS && Arrays.stream(meanLog).allMatch(Double::isFinite)) {
            double[] alpha = DirichletFit.fromMeanLog(meanLog);
            if (alpha != null) {
                return of(alpha, p);
            }
        }
        return new DirichletBelief<>(m, DirichletFit.concentration(new Moments(m, moments.square())), p);
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof DirichletBelief<?> d && Arrays.equals(mean, d.mean) && concentration == d.concentration
                && projection == d.projection;
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(mean) + Double.hashCode(concentration);
    }
}
