package handover.domain;

import handover.math.Vector3;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Angles and Z(v) of MODEL 3.1 and 4.2 a second time, by other formulas than the code under test. */
public final class PointingOracle {
    private static final int PANELS = 200_000;
    private static final Map<Double, Double> NORMALISERS = new ConcurrentHashMap<>();

    private PointingOracle() {}

    /** The angle at {@code from} between two points, as that of an isosceles triangle with sides of length 1. */
    static double angle(Vector3 from, Vector3 a, Vector3 b) {
        double[] u = unit(a.x() - from.x(), a.y() - from.y(), a.z() - from.z());
        double[] w = unit(b.x() - from.x(), b.y() - from.y(), b.z() - from.z());
        double apart = 0;
        double together = 0;
        for (int k = 0; k < 3; k++) {
            apart += (u[k] - w[k]) * (u[k] - w[k]);
            together += (u[k] + w[k]) * (u[k] + w[k]);
        }
        return 2 * Math.atan2(Math.sqrt(apart), Math.sqrt(together));
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    /** Z(v) by Simpson's rule. */
    public static double normaliser(double v) {
        return NORMALISERS.computeIfAbsent(v, k -> {
            double sum = 0;
            for (int panel = 0; panel <= 2 * PANELS; panel++) {
                double t = panel * Math.PI / (2 * PANELS);
                int weight = panel == 0 || panel == 2 * PANELS ? 1 : panel % 2 == 1 ? 4 : 2;
                sum += weight * Math.sin(t) * Math.exp(-t * t / (2 * v));
            }
            return 2 * Math.PI * sum * Math.PI / (6 * PANELS);
        });
    }
}
