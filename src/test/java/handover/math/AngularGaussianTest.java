package handover.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.domain.PointingOracle;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** MODEL 4.2: the density of a pointing direction, and the sampler that matches it. */
class AngularGaussianTest {
    private static final int DRAWS = 40_000;
    private static final double FALSE_ALARM = 1e-6;
    private static final int PANELS = 100_000;

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e-3, 0.01, 0.0225, 0.04, 0.4, 1, 1.999, 2, 2.001, 5, 10})
    void theNormaliserIsTheIntegral(double v) {
        double z = new AngularGaussian(v, 0).normaliser();
        assertEquals(1, z / PointingOracle.normaliser(v), 1e-9, () -> "Z(" + v + ") = " + z);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 0.04, 1, 10})
    void theDensityIntegratesToOneOverTheSphere(double v) {
        for (double eps : new double[] {0, 0.05, 0.5, 1}) {
            assertEquals(1, cumulative(new AngularGaussian(v, eps))[PANELS], 1e-6, "v = " + v + ", eps = " + eps);
        }
    }

    @Test
    void byHand() {
        assertEquals(1 / (4 * Math.PI), new AngularGaussian(0.04, 1).density(2), 1e-15, "nothing but outliers");
        AngularGaussian f = new AngularGaussian(0.04, 0);
        assertEquals(-0.5, Math.log(f.density(0.2) / f.density(0)), 1e-12, "one standard deviation");
        assertEquals(4 * Math.PI, new AngularGaussian(1e3, 0).normaliser(), 0.05, "a flat density covers the sphere");
        assertEquals(2 * Math.PI * 1e-4, new AngularGaussian(1e-4, 0).normaliser(), 1e-7, "a narrow one is flat space");
    }

    /** Both branches of the sampler (below and above v = 2) and outliers. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 0.04, 0.5, 1.99, 2.01, 10})
    void anglesFollowTheDensity(double v) {
        for (double eps : new double[] {0, 0.3}) {
            AngularGaussian f = new AngularGaussian(v, eps);
            SplittableRandom random = new SplittableRandom(19);
            Vector3 mean = new Vector3(0.3, -2, 0.1);
            double[] angles = new double[DRAWS];
            for (int k = 0; k < DRAWS; k++) {
                Vector3 d = f.sample(mean, random);
                assertEquals(1, d.norm(), 1e-12, "unit length");
                angles[k] = mean.angleTo(d);
            }
            double[] sums = cumulative(f);
            GoodnessOfFit.assertFollows("angles for v = " + v + ", eps = " + eps, angles,
                    t -> sums[(int) Math.min(PANELS, Math.round(t / Math.PI * PANELS))], FALSE_ALARM);
        }
    }

    @Test
    void theAzimuthIsUniform() {
        for (Vector3 mean : new Vector3[] {new Vector3(0, 0, 1), new Vector3(1, 0, 0), new Vector3(1, 2, -3)}) {
            AngularGaussian f = new AngularGaussian(0.1, 0.1);
            SplittableRandom random = new SplittableRandom(20);
            // Two axes across the mean: the first from any vector that is not parallel to it.
            Vector3 u = mean.cross(new Vector3(0.3, 0.8, -0.2)).unit();
            Vector3 w = mean.cross(u).unit();
            double[] azimuths = new double[DRAWS];
            for (int k = 0; k < DRAWS; k++) {
                Vector3 d = f.sample(mean, random);
                azimuths[k] = Math.atan2(d.dot(w), d.dot(u));
            }
            GoodnessOfFit.assertFollows("azimuths about " + mean, azimuths, a -> a / (2 * Math.PI) + 0.5, FALSE_ALARM);
        }
    }

    /** P(angle &lt;= k pi / PANELS) by the midpoint rule, from the density alone. */
    private static double[] cumulative(AngularGaussian f) {
        double[] sums = new double[PANELS + 1];
        for (int k = 0; k < PANELS; k++) {
            double t = (k + 0.5) * Math.PI / PANELS;
            sums[k + 1] = sums[k] + 2 * Math.PI * Math.sin(t) * f.density(t) * Math.PI / PANELS;
        }
        return sums;
    }
}
