package handover.math;

import java.util.random.RandomGenerator;
import org.hipparchus.analysis.integration.gauss.GaussIntegrator;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;

/**
 * A density over directions on the unit sphere, Gaussian in the angle t to a mean direction, mixed with the uniform
 * one: f = (1-eps) exp(-t^2/(2v)) / Z(v) + eps/(4 pi), per steradian; MODEL section 4.2. Immutable, thread safe.
 */
public final class AngularGaussian {
    private static final double UNIFORM = 1 / (4 * Math.PI);
    private static final int PANELS = 40;
    private static final int POINTS = 20;

    private final double variance;
    private final double outliers;
    private final double normaliser;

    /**
     * @param variance v in rad^2, positive
     * @param outliers eps in [0, 1], the share of gestures that mean nothing
     */
    public AngularGaussian(double variance, double outliers) {
        this.variance = variance;
        this.outliers = outliers;
        this.normaliser = integrate(variance);
    }

    /** f at angle {@code t} (radians, 0..pi) from the mean direction, per steradian. */
    public double density(double t) {
        return (1 - outliers) * Math.exp(-t * t / (2 * variance)) / normaliser + outliers * UNIFORM;
    }

    /** log f, exact also where f underflows. */
    public double logDensity(double t) {
        return outliers > 0 ? Math.log(density(t)) : -t * t / (2 * variance) - Math.log(normaliser);
    }

    /** Z(v) = 2 pi int_0^pi sin(t) exp(-t^2/(2v)) dt, in steradians. */
    public double normaliser() {
        return normaliser;
    }

    /** A unit direction drawn from f about {@code mean} (any length but zero). */
    public Vector3 sample(Vector3 mean, RandomGenerator random) {
        Vector3 axis = mean.unit();
        if (random.nextDouble() < outliers) {
            return turn(axis, Math.acos(1 - 2 * random.nextDouble()), random);
        }
        return turn(axis, sampleAngle(random), random);
    }

    /**
     * An angle with density proportional to sin(t) exp(-t^2/(2v)) on [0, pi], by rejection: from a Rayleigh draw
     * (density t exp(-t^2/(2v))) where v is small, from a uniform direction (density sin(t)/2) where it is large.
     */
    private double sampleAngle(RandomGenerator random) {
        while (true) {
            if (variance < 2) {
                double t = Math.sqrt(-2 * variance * Math.log(1 - random.nextDouble()));
                if (t <= Math.PI && random.nextDouble() * t <= Math.sin(t)) {
                    return t;
                }
            } else {
                double t = Math.acos(1 - 2 * random.nextDouble());
                if (random.nextDouble() <= Math.exp(-t * t / (2 * variance))) {
                    return t;
                }
            }
        }
    }

    /** The unit vector at angle {@code t} from the unit vector {@code axis}, at a uniform azimuth. */
    private static Vector3 turn(Vector3 axis, double t, RandomGenerator random) {
        Vector3 other = Math.abs(axis.z()) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
        Vector3 u = axis.cross(other).unit();
        Vector3 w = axis.cross(u);
        double azimuth = 2 * Math.PI * random.nextDouble();
        return axis.times(Math.cos(t))
                .plus(u.times(Math.sin(t) * Math.cos(azimuth)))
                .plus(w.times(Math.sin(t) * Math.sin(azimuth)));
    }

    /** Gauss-Legendre over panels that follow the width of the peak; beyond 12 standard deviations it is below 1e-31. */
    private static double integrate(double v) {
        GaussIntegratorFactory factory = new GaussIntegratorFactory();
        double end = Math.min(Math.PI, 12 * Math.sqrt(v));
        double sum = 0;
        for (int k = 0; k < PANELS; k++) {
            GaussIntegrator panel = factory.legendre(POINTS, end * k / PANELS, end * (k + 1) / PANELS);
            sum += panel.integrate(t -> Math.sin(t) * Math.exp(-t * t / (2 * v)));
        }
        return 2 * Math.PI * sum;
    }
}
