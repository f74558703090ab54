package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The integrals of MODEL 8 against 30-digit values, other quadratures, closed forms and each other. */
class ScaledDirichletTest {
    /**
     * alpha, l, E[beta'_j], E[beta'_j^2]; from mpmath 1.3 with 30 digits, the integrals of MODEL 8 split into 400 panels.
     */
    record Golden(double[] alpha, double[] likelihood, double[] mean, double[] square) {}

    static Stream<Golden> golden() {
        return Stream.of(
                new Golden(v(0.05, 0.05), v(1, 1e-12), v(0.87340329669757183, 0.12659670330242817),
                        v(0.86707346153248777, 0.1202668681373441)),
                new Golden(v(0.05, 3), v(1e-12, 1), v(2.4999999999973751e-14, 0.999999999999975),
                        v(2.6249999997244527e-26, 0.99999999999995)),
                new Golden(v(500, 500), v(0.3, 0.7), v(0.3001679125503236, 0.6998320874496764),
                        v(0.090277224645828972, 0.48994139954518177)),
                new Golden(v(500, 0.05, 20), v(1e-12, 1, 1e-6),
                        v(1.574123566869301e-5, 0.40024271999348655, 0.59974153877084475),
                        v(4.150642208057614e-10, 0.37026283106858005, 0.56974748274865792)),
                new Golden(v(0.05, 0.05, 0.05), v(0.2, 0, 0.9), v(0.46601898156371463, 0, 0.53398101843628537),
                        v(0.44368891872656563, 0, 0.51165095559913636)),
                new Golden(v(1, 2, 3, 4), v(0.1, 0.2, 0.3, 0.4),
                        v(0.035977539433070095, 0.13891234596037246, 0.30268023947492382, 0.52242987513163362),
                        v(0.0026840013506460443, 0.027985361025095333, 0.11161632060583467, 0.29723898369867967)),
                new Golden(v(500, 500, 500), v(1, 1e-3, 1e-12),
                        v(0.99899900301401079, 0.0010009969849882144, 1.0009989929941037e-12),
                        v(0.99799901203493092, 1.0060069073378287e-6, 1.0060149957782935e-24)),
                new Golden(v(0.7, 0.05, 40, 500, 2.5), v(0.9, 1, 0.02, 1e-9, 0.4),
                        v(0.21675337135748323, 0.016800360407782876, 0.37018479410399832, 2.3381692437353641e-7,
                                0.3962612403138112),
                        v(0.080466352914562078, 0.004072373294594937, 0.15710583601544668, 6.288000083611127e-14,
                                0.1855212410054458)));
    }

    private static double[] v(double... x) {
        return x;
    }

    @ParameterizedTest
    @MethodSource("golden")
    void agreesWithThirtyDigits(Golden g) {
        ScaledDirichlet law = new ScaledDirichlet(g.alpha, g.likelihood);
        double[] mean = law.mean();
        DMatrixRMaj s = law.secondMoments();
        for (int j = 0; j < mean.length; j++) {
            assertEquals(g.mean[j], mean[j], 1e-12 * g.mean[j] + 1e-18);
            assertEquals(g.square[j], s.get(j, j), 1e-12 * g.square[j] + 1e-18);
        }
    }

    /** The Frullani integral of E[log beta'], from mpmath with 30 digits. */
    @Test
    void meanLogarithmsAgreeWithThirtyDigits() {
        assertArrayEquals(v(-1.60950041317927283, -20.7819613351233823, -0.519811975216814849),
                new ScaledDirichlet(v(0.7, 0.05, 40), v(0.9, 1, 0.02)).meanLog(), 1e-13);
    }

    /** Sums are one; the one-pass moments are the same; the covariance has no negative diagonal. */
    @Property(tries = 150)
    void sums(@ForAll @IntRange(min = 1, max = 100) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        ScaledDirichlet law = new ScaledDirichlet(RandomDirichlets.alpha(n, random), RandomDirichlets.likelihood(n, random));
        double[] mean = law.mean();
        DMatrixRMaj s = law.secondMoments();
        assertEquals(1, Arrays.stream(mean).sum(), 1e-12);
        assertEquals(1, CommonOps_DDRM.elementSum(s), 1e-11);
        Moments both = law.moments();
        assertArrayEquals(mean, both.mean(), 1e-13);
        assertEquals(CommonOps_DDRM.trace(s), both.square(), 1e-12);
        for (int j = 0; j < n; j++) {
            double row = 0;
            for (int k = 0; k < n; k++) {
                row += s.get(j, k);
            }
            assertEquals(mean[j], row, 1e-12, "sum_k E[b_j b_k] = E[b_j]");
            assertEquals(true, s.get(j, j) >= mean[j] * mean[j] * (1 - 1e-9));
        }
    }

    /** The integrals as MODEL 8 writes them, in s, by Gauss-Legendre on panels of one tenth of a decade. */
    @Property(tries = 60)
    void agreesWithGaussLegendre(@ForAll @IntRange(min = 2, max = 12) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] alpha = RandomDirichlets.alpha(n, random);
        double[] l = RandomDirichlets.likelihood(n, random);
        ScaledDirichlet law = new ScaledDirichlet(alpha, l);
        int j = random.nextInt(n);
        int k = random.nextInt(n);
        double end = Math.pow(10, Math.min(290, 20 + 18 / totalPossible(alpha, l)));
        double mean = gauss(s -> l[j] * alpha[j] / (1 + l[j] * s) * decay(alpha, l, s), end);
        double second = gauss(s -> s * l[j] * l[k] * alpha[j] * (alpha[k] + (j == k ? 1 : 0))
                / ((1 + l[j] * s) * (1 + l[k] * s)) * decay(alpha, l, s), end);
        assertEquals(mean, law.mean()[j], 1e-8);
        assertEquals(second, law.secondMoments().get(j, k), 1e-8);
    }

    private static double totalPossible(double[] alpha, double[] l) {
        double sum = 0;
        for (int k = 0; k < alpha.length; k++) {
            sum += l[k] > 0 ? alpha[k] : 0;
        }
        return sum;
    }

    private static double decay(double[] alpha, double[] l, double s) {
        double product = 1;
        for (int k = 0; k < alpha.length; k++) {
            product *= Math.pow(1 + l[k] * s, -alpha[k]);
        }
        return product;
    }

    private static double gauss(DoubleUnaryOperator f, double end) {
        GaussIntegratorFactory factory = new GaussIntegratorFactory();
        double sum = factory.legendre(20, 0, 1e-20).integrate(f::applyAsDouble);
        for (double a = 1e-20; a < end; a *= Math.pow(10, 0.1)) {
            sum += factory.legendre(10, a, a * Math.pow(10, 0.1)).integrate(f::applyAsDouble);
        }
        return sum;
    }

    /**
     * Two objects: one integral over a Beta density, a different one from those of MODEL 8 (the first object is the
     * likelier one, so that the step of the posterior is near x = 0, where doubles are dense).
     */
    @Property(tries = 100)
    void agreesWithTheBetaIntegralOfTwoObjects(@ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] alpha = RandomDirichlets.alpha(2, random);
        double ratio = Math.pow(1e-12, random.nextDouble());
        double[] l = {0.3, 0.3 * ratio};
        BetaMarginal prior = new BetaMarginal(alpha[0] / (alpha[0] + alpha[1]), alpha[0] + alpha[1]);
        DoubleUnaryOperator posterior = x -> l[0] * x / (l[0] * x + l[1] * (1 - x));
        ScaledDirichlet law = new ScaledDirichlet(alpha, l);
        assertEquals(prior.expectation(posterior), law.mean()[0], 1e-9);
        assertEquals(prior.expectation(x -> Math.pow(posterior.applyAsDouble(x), 2)), law.secondMoments().get(0, 0), 1e-9);
    }

    /** beta ~ U(0,1), odds multiplied by r: E[beta'] = r (r - 1 - log r) / (r-1)^2. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-12, 1e-3, 0.5, 2, 1e6})
    void uniformBeliefOfTwoObjects(double r) {
        double expected = r * (r - 1 - Math.log(r)) / ((r - 1) * (r - 1));
        assertEquals(expected, new ScaledDirichlet(v(1, 1), v(r, 1)).mean()[0], 1e-12);
    }

    /** E[beta'_1] = (a l_1 / ((a+b) l_2)) 2F1(1, a+1; a+b+1; 1 - l_1/l_2), by its series. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.5, 0.9, 1, 1.5, 1.9})
    void hypergeometricSeriesOfTwoObjects(double r) {
        double a = 0.7;
        double b = 3.3;
        double term = 1;
        double sum = 0;
        for (int k = 0; k < 2000; k++) {
            sum += term;
            term *= (a + 1 + k) / (a + b + 1 + k) * (1 - r);
        }
        assertEquals(r * a / (a + b) * sum, new ScaledDirichlet(v(a, b), v(r, 1)).mean()[0], 1e-12);
    }

    @Test
    void equalLikelihoodsChangeNothing() {
        ScaledDirichlet law = new ScaledDirichlet(v(1, 2, 5), v(0.3, 0.3, 0.3));
        assertArrayEquals(v(0.125, 0.25, 0.625), law.mean(), 1e-14);
        assertEquals(2.0 * 3 / (8 * 9), law.secondMoments().get(1, 1), 1e-14);
        assertEquals(1.0 * 5 / (8 * 9), law.secondMoments().get(0, 2), 1e-14);
        double[] g = law.meanLog();
        for (int j = 0; j < 3; j++) {
            assertEquals(Digamma.of(v(1, 2, 5)[j]) - Digamma.of(8), g[j], 1e-12);
        }
    }

    /** What rules objects out and is equal on the rest leaves a Dirichlet on the rest, Dir(alpha_X). */
    @Test
    void rulingOutLeavesTheDirichletOfTheRest() {
        ScaledDirichlet law = new ScaledDirichlet(v(1, 2, 5), v(0, 0.4, 0.4));
        assertArrayEquals(v(0, 2 / 7.0, 5 / 7.0), law.mean(), 1e-14);
        assertEquals(5.0 * 6 / (7 * 8), law.secondMoments().get(2, 2), 1e-14);
        assertArrayEquals(v(0, 1, 0), new ScaledDirichlet(v(1, 2, 5), v(0, 0.4, 0)).mean(), 1e-14);
        assertArrayEquals(v(1), new ScaledDirichlet(v(0.05), v(1e-12)).mean(), 1e-14);
    }

    /** The scale of the likelihoods does not matter, even beyond the range of doubles' products. */
    @Test
    void onlyRatiosMatter() {
        double[] expected = new ScaledDirichlet(v(0.5, 3), v(0.2, 1)).mean();
        assertArrayEquals(expected, new ScaledDirichlet(v(0.5, 3), v(0.2e-300, 1e-300)).mean(), 1e-14);
    }

    /** The order of objects does not matter. */
    @Test
    void objectsMayBeReordered() {
        double[] one = new ScaledDirichlet(v(0.05, 40, 3), v(1, 1e-5, 0.1)).meanLog();
        double[] other = new ScaledDirichlet(v(3, 0.05, 40), v(0.1, 1, 1e-5)).meanLog();
        assertArrayEquals(v(one[2], one[0], one[1]), other, 1e-12);
    }

    @Test
    void refusesWhatIsImpossible() {
        assertThrows(IllegalArgumentException.class, () -> new ScaledDirichlet(v(1, 1), v(0, 0)));
        assertThrows(IllegalArgumentException.class, () -> new ScaledDirichlet(v(0, 1), v(1, 0)));
        assertThrows(IllegalArgumentException.class, () -> new ScaledDirichlet(v(1, -1), v(1, 1)));
        assertThrows(IllegalArgumentException.class, () -> new ScaledDirichlet(v(1, 1), v(1, Double.NaN)));
    }
}
