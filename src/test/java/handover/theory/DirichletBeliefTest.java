package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.theory.Agent.Robot;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The Dirichlet projection, its updates, and its limits. */
class DirichletBeliefTest {
    private static DirichletBelief<Robot> dirichlet(double... alpha) {
        return DirichletBelief.of(alpha, Projection.MOMENTS);
    }

    private static DirichletBelief<Robot> random(int n, SplittableRandom random, Projection projection) {
        return DirichletBelief.of(RandomDirichlets.alpha(n, random), projection);
    }

    @Property(tries = 100)
    void projectionOfADirichletIsItself(@ForAll @IntRange(min = 2, max = 30) int n, @ForAll long seed) {
        DirichletBelief<Robot> b = random(n, new SplittableRandom(seed), Projection.MOMENTS);
        double total = DirichletFit.concentration(new Moments(b.mean(), b.meanSquare()));
        assertEquals(b.concentration(), total, 1e-9 * b.concentration() * (1 + b.concentration() / 100));
        double[] alpha = DirichletFit.fromMeanLog(b.meanLog());
        for (int j = 0; j < n; j++) {
            assertEquals(b.alpha()[j], alpha[j], 1e-9 * b.concentration());
        }
    }

    /** After every update the mean and E ||beta||^2 of the exact mixture are kept. */
    @Property(tries = 60)
    void perceptionKeepsTheMomentsOfTheMixture(@ForAll @IntRange(min = 2, max = 12) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DirichletBelief<Robot> b = random(n, random, Projection.MOMENTS);
        Perception<Robot> act = RandomTheory.perception(n, random);
        double[] mean = new double[n];
        double q = 0;
        for (int a = 0; a < act.size(); a++) {
            ScaledDirichlet law = new ScaledDirichlet(b.alpha(), act.messages().get(a).likelihood());
            q += act.probabilities()[a] * CommonOps_DDRM.trace(law.secondMoments());
            for (int j = 0; j < n; j++) {
                mean[j] += act.probabilities()[a] * law.mean()[j];
            }
        }
        DirichletBelief<Robot> next = b.perceived(act);
        assertArrayEquals(mean, next.mean(), 1e-12);
        assertEquals(q, next.meanSquare(), 1e-12);
    }

    @Property(tries = 60)
    void logProjectionKeepsTheMeanLogarithms(@ForAll @IntRange(min = 2, max = 12) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DirichletBelief<Robot> b = random(n, random, Projection.LOG_MOMENTS);
        Perception<Robot> act = RandomTheory.perception(n, random);
        double[] g = new double[n];
        for (int a = 0; a < act.size(); a++) {
            double[] part = new ScaledDirichlet(b.alpha(), act.messages().get(a).likelihood()).meanLog();
            for (int j = 0; j < n; j++) {
                g[j] += act.probabilities()[a] * part[j];
            }
        }
        double[] kept = b.perceived(act).meanLog();
        for (int j = 0; j < n; j++) {
            assertEquals(g[j], kept[j], 1e-8 * Math.max(1, Math.abs(g[j])));
        }
    }

    /** T^T m and T^T S T, S by its definition. */
    @Property(tries = 60)
    void predictionMapsTheMoments(@ForAll @IntRange(min = 2, max = 12) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DirichletBelief<Robot> b = random(n, random, Projection.MOMENTS);
        Transition<Robot> t = RandomTheory.transition(n, random);
        double[] a = b.alpha();
        double total = b.concentration();
        DMatrixRMaj s = new DMatrixRMaj(n, n);
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < n; k++) {
                s.set(j, k, a[j] * (a[k] + (j == k ? 1 : 0)) / (total * (total + 1)));
            }
        }
        assertTrue(MatrixFeatures_DDRM.isIdentical(s, b.secondMoments(), 1e-12));
        double q = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                for (int k = 0; k < n; k++) {
                    q += t.matrix().get(j, i) * s.get(j, k) * t.matrix().get(k, i);
                }
            }
        }
        DirichletBelief<Robot> next = b.predicted(t);
        assertEquals(q, next.meanSquare(), 1e-11);
        assertArrayEquals(t.moved(b.mean()), next.mean(), 1e-12);
    }

    /** The mixture w_j Dir(alpha + e_j), component by component. */
    @Property(tries = 60)
    void evidenceGivesTheMomentsOfItsMixture(@ForAll @IntRange(min = 2, max = 12) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DirichletBelief<Robot> b = random(n, random, Projection.MOMENTS);
        double[] l = RandomDirichlets.likelihood(n, random);
        double z = 0;
        for (int j = 0; j < n; j++) {
            z += l[j] * b.alpha()[j];
        }
        double[] mean = new double[n];
        double[] logs = new double[n];
        double q = 0;
        for (int j = 0; j < n; j++) {
            double[] alpha = b.alpha();
            double w = l[j] * alpha[j] / z;
            alpha[j] += 1;
            DirichletBelief<Robot> part = dirichlet(alpha);
            q += w * part.meanSquare();
            for (int k = 0; k < n; k++) {
                mean[k] += w * part.mean()[k];
                logs[k] += w * part.meanLog()[k];
            }
        }
        DirichletBelief<Robot> next = b.given(new Evidence<>(l));
        assertArrayEquals(mean, next.mean(), 1e-12);
        assertEquals(q, next.meanSquare(), 1e-11);
        double[] g = new DirichletBelief<Robot>(b.mean(), b.concentration(), Projection.LOG_MOMENTS)
                .given(new Evidence<>(l)).meanLog();
        for (int k = 0; k < n; k++) {
            assertEquals(logs[k], g[k], 1e-8 * Math.max(1, Math.abs(logs[k])));
        }
    }

    /** "It is object j" is a draw from beta: here, and only here, counting is exact. */
    @Test
    void namingAnObjectAddsOneCount() {
        DirichletBelief<Robot> b = dirichlet(1, 2, 5).given(new Evidence<>(new double[] {0, 1, 0}));
        assertArrayEquals(new double[] {1, 3, 5}, b.alpha(), 1e-12);
    }

    @Test
    void conjugateSpecialCases() {
        DirichletBelief<Robot> b = dirichlet(1, 2, 5);
        assertSame(b, b.perceived(Perception.exact(Message.nothing(3))));
        assertSame(b, b.perceived(Perception.exact(new Message<>(new double[3]))));
        assertSame(b, b.given(new Evidence<>(new double[3])));
        assertSame(b, b.predicted(Transition.stay(3, 1)));
        assertArrayEquals(new double[] {0, 2, 5}, b.perceived(Perception.exact(new Message<>(new double[] {0, 3, 3})))
                .alpha(), 1e-11);
        assertArrayEquals(new double[] {0, 1, 0}, b.perceived(Perception.exact(new Message<>(new double[] {0, 3, 0})))
                .mean(), 1e-14);
    }

    @ParameterizedTest
    @EnumSource(Projection.class)
    void aKnownBeliefFollowsBayesRule(Projection projection) {
        Categorical<Robot> beta = new Categorical<>(new double[] {0.2, 0.3, 0.5});
        Transition<Robot> t = Transition.stay(3, 0.9);
        Message<Robot> a = new Message<>(new double[] {0.7, 0.1, 0.2});
        DirichletBelief<Robot> b = DirichletBelief.certain(beta, projection);
        DirichletBelief<Robot> next = b.predicted(t).perceived(Perception.exact(a));
        assertArrayEquals(beta.updated(t, a).probabilities(), next.mean(), 1e-12);
        assertEquals(0, next.variance(), 1e-12);
        assertEquals(Double.POSITIVE_INFINITY, next.concentration());
        assertSame(b, b.given(new Evidence<>(new double[] {1, 0, 0})));
        assertArrayEquals(b.mean(), b.sample(new SplittableRandom(1)));
    }

    /**
     * The other is sure of one object, only of which is open: an act cannot move it, evidence weighs, a prediction
     * spreads.
     */
    @Test
    void verticesAreTheOtherLimit() {
        DirichletBelief<Robot> b = new DirichletBelief<>(new double[] {0.5, 0.5}, 0, Projection.MOMENTS);
        assertEquals(1, b.meanSquare());
        assertArrayEquals(new double[] {0.5, 0.5}, b.perceived(Perception.exact(new Message<>(new double[] {0.9, 0.1})))
                .mean(), 1e-15);
        assertArrayEquals(new double[] {0.9, 0.1}, b.given(new Evidence<>(new double[] {0.9, 0.1})).mean(), 1e-12);
        DirichletBelief<Robot> spread = b.predicted(Transition.stay(2, 0.9));
        assertEquals(0.9 * 0.9 + 0.1 * 0.1, spread.meanSquare(), 1e-12);
        assertTrue(spread.concentration() > 0);
    }

    @ParameterizedTest
    @EnumSource(Projection.class)
    void oneObjectIsAlwaysCertain(Projection projection) {
        DirichletBelief<Robot> b = DirichletBelief.of(new double[] {3}, projection);
        b = b.predicted(Transition.stay(1, 0.5)).perceived(Perception.exact(new Message<>(new double[] {0.2})))
                .given(new Evidence<>(new double[] {0.1}));
        assertArrayEquals(new double[] {1}, b.mean());
        assertEquals(0, b.variance());
    }

    /** Nothing was perceived differently: a mixture without variance stays a point. */
    @Test
    void aMixtureWithoutVarianceIsAPoint() {
        DirichletBelief<Robot> b = DirichletBelief.project(new Atoms<>(new double[] {0.4, 0.6},
                List.of(new double[] {0.3, 0.7}, new double[] {0.3, 0.7})), Projection.MOMENTS);
        assertEquals(Double.POSITIVE_INFINITY, b.concentration());
    }

    /** 200,000 draws; mean and second moments within 4 standard errors (6 comparisons: odds 4e-4). */
    @Test
    void samplesHaveTheMoments() {
        DirichletBelief<Robot> b = dirichlet(0.3, 2, 40);
        Particles<Robot> drawn = Particles.of(b, 200_000, new SplittableRandom(6));
        for (int j = 0; j < 3; j++) {
            double s = b.secondMoments().get(j, j);
            double error = Math.sqrt((s - b.mean()[j] * b.mean()[j]) / 200_000);
            assertEquals(b.mean()[j], drawn.mean()[j], 4 * error);
            assertEquals(s, drawn.secondMoments().get(j, j), 8 * error);
        }
    }

    @Test
    void changesFromExactToDirichletWhenAtomsBecomeTooMany() {
        SplittableRandom random = new SplittableRandom(7);
        Transition<Robot> t = Transition.stay(4, 0.95);
        Adaptive<Robot> b = Adaptive.certain(Categorical.uniform(4), 64, Projection.MOMENTS);
        Atoms<Robot> exact = Atoms.certain(Categorical.uniform(4));
        for (int k = 1; k <= 4; k++) {
            Perception<Robot> act = RandomTheory.perception(4, random);
            b = b.predicted(t).perceived(act);
            exact = exact.predicted(t).perceived(act);
            assertEquals(k <= 3, b.exact());
            assertArrayEquals(exact.mean(), b.mean(), 1e-12);
            assertEquals(exact.meanSquare(), b.meanSquare(), 1e-12);
        }
        b = b.predicted(t).perceived(RandomTheory.perception(4, random)).given(new Evidence<>(new double[] {1, 2, 3, 4}));
        assertFalse(b.exact());
        assertEquals(1, Arrays.stream(b.mean()).sum(), 1e-12);
    }

    /** No shape of a Dirichlet, however extreme, is refused or gives something that is no distribution. */
    @Property(tries = 300)
    void extremesStayFinite(@ForAll @IntRange(min = 1, max = 6) int n, @ForAll @IntRange(min = -320, max = 300) int exponent,
            @ForAll Projection projection, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DirichletBelief<Robot> b = new DirichletBelief<>(RandomDirichlets.belief(n, random), Math.pow(10, exponent),
                projection);
        for (int k = 0; k < 3; k++) {
            Perception<Robot> act = new Perception<>(new double[] {0.7, 0.3}, List.of(new Message<>(
                    RandomDirichlets.likelihood(n, random)), new Message<>(RandomDirichlets.likelihood(n, random))));
            b = b.perceived(act).given(new Evidence<>(RandomDirichlets.likelihood(n, random)));
            assertEquals(1, Arrays.stream(b.mean()).sum(), 1e-9);
            assertTrue(b.meanSquare() <= 1 + 1e-12 && b.concentration() >= 0);
            b = b.predicted(Transition.stay(n, k == 1 ? 0.9 : 1));
        }
    }

    @Test
    void refusesWhatIsNoDirichlet() {
        assertThrows(IllegalArgumentException.class, () -> dirichlet(1, -1));
        assertThrows(IllegalArgumentException.class, () -> dirichlet(0, 0));
        assertThrows(IllegalArgumentException.class, () -> new DirichletBelief<Robot>(new double[] {1}, Double.NaN,
                Projection.MOMENTS));
        assertThrows(IllegalArgumentException.class, () -> new Adaptive<>(dirichlet(1, 1), 0, Projection.MOMENTS));
    }
}
