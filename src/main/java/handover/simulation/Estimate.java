package handover.simulation;

import java.util.Collection;
import org.hipparchus.distribution.continuous.NormalDistribution;
import org.hipparchus.distribution.continuous.TDistribution;
import org.hipparchus.stat.descriptive.StreamingStatistics;

/**
 * An estimate with its 95% interval. Immutable.
 *
 * @param value the estimate
 * @param low lower end
 * @param high upper end
 */
public record Estimate(double value, double low, double high) {
    private static final double TAIL = 0.975;

    /** The mean of independent numbers, with Student's interval (unbounded for fewer than two numbers). */
    public static Estimate mean(Collection<Double> xs) {
        StreamingStatistics s = new StreamingStatistics();
        xs.forEach(s::addValue);
        double half = s.getN() < 2 ? Double.POSITIVE_INFINITY
                : new TDistribution(s.getN() - 1).inverseCumulativeProbability(TAIL) * s.getStandardDeviation()
                        / Math.sqrt(s.getN());
        return new Estimate(s.getMean(), s.getMean() - half, s.getMean() + half);
    }

    /** A share of independent trials, with Wilson's interval. */
    public static Estimate share(int successes, int trials) {
        double z = new NormalDistribution().inverseCumulativeProbability(TAIL);
        double p = (double) successes / trials;
        double centre = (p + z * z / (2 * trials)) / (1 + z * z / trials);
        double half = z / (1 + z * z / trials) * Math.sqrt(p * (1 - p) / trials + z * z / (4.0 * trials * trials));
        return new Estimate(p, Math.max(0, centre - half), Math.min(1, centre + half));
    }

    /** Half the width of the interval. */
    public double half() {
        return (high - low) / 2;
    }
}
