package handover.theory;

import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Puts equal beliefs together: sorted along one fixed direction in log beta, along which equal beliefs are neighbours, so that
 * the cost is n log n and not n^2.
 */
final class Merging {
    /** The fractional parts of its multiples spread evenly, so that different beliefs rarely share a projection. */
    private static final double GOLDEN = 0.6180339887498949;
    /** Entries below this (no longer of full precision) count as equal. */
    private static final double SMALLEST = 1e-290;

    private Merging() {}

    /** The atoms with equal ones merged and those of weight zero left out; the arguments are not modified. */
    static <S extends Agent<?, ?>> Atoms<S> merged(double[] w, List<double[]> points) {
        double[] place = points.stream().mapToDouble(Merging::projection).toArray();
        int[] order = IntStream.range(0, w.length).filter(k -> w[k] > 0).boxed()
                .sorted(Comparator.comparingDouble(k -> place[k])).mapToInt(k -> k).toArray();
        double reach = 2 * points.get(0).length * Atoms.TOLERANCE;
        double[] weights = new double[order.length];
        double[] places = new double[order.length];
        List<double[]> kept = new ArrayList<>();
        for (int k : order) {
            int same = kept.size() - 1;
            while (same >= 0 && place[k] - places[same] <= reach && !equal(kept.get(same), points.get(k))) {
                same--;
            }
            if (same >= 0 && place[k] - places[same] <= reach) {
                weights[same] += w[k];
            } else {
                places[kept.size()] = place[k];
                weights[kept.size()] = w[k];
                kept.add(points.get(k));
            }
        }
        weights = Arrays.copyOf(weights, kept.size());
        Simplex.normalise(weights, weights.length);
        return new Atoms<>(weights, kept);
    }

    private static double projection(double[] p) {
        double s = 0;
        for (int i = 0; i < p.length; i++) {
            s += Math.log(Math.max(p[i], SMALLEST)) * ((i + 1) * GOLDEN % 1);
        }
        return s;
    }

    private static boolean equal(double[] p, double[] q) {
        for (int i = 0; i < p.length; i++) {
            double larger = Math.max(p[i], q[i]);
            if (Math.abs(p[i] - q[i]) > Atoms.TOLERANCE * larger && larger > SMALLEST) {
                return false;
            }
        }
        return true;
    }
}
