package handover.theory;

import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Puts equal beliefs together: sorted along one fixed direction in log beta, along which equal beliefs are neighbours, so
 * that the cost is n log n and not n^2.
 */
public final class Merging {
    /** The fractional parts of its multiples spread evenly, so that different beliefs rarely share a projection. */
    private static final double GOLDEN = 0.6180339887498949;
    /** Entries below this (no longer of full precision) count as equal. */
    private static final double SMALLEST = 1e-290;

    private Merging() {}

    /**
     * Which of the beliefs are equal: a number for each, counted from 0 in the order of {@code points}' first occurrences
     * along the direction; not modified.
     */
    public static int[] groups(List<double[]> points) {
        double reach = 4 * points.get(0).length * Atoms.TOLERANCE;
        double[] place = points.stream().mapToDouble(Merging::projection).toArray();
        if (apart(place, reach)) {
            return IntStream.range(0, place.length).toArray();
        }
        int[] order = IntStream.range(0, place.length).boxed().sorted(Comparator.comparingDouble(k -> place[k]))
                .mapToInt(k -> k).toArray();
        int[] group = new int[order.length];
        int[] first = new int[order.length];
        int count = 0;
        for (int k : order) {
            int same = count - 1;
            while (same >= 0 && place[k] - place[first[same]] <= reach && !equal(points.get(first[same]), points.get(k))) {
                same--;
            }
            boolean found = same >= 0 && place[k] - place[first[same]] <= reach;
            group[k] = found ? same : count;
            if (!found) {
                first[count++] = k;
            }
        }
        return group;
    }

    /** The atoms with equal ones merged and those of weight zero left out; the arguments are not modified. */
    static <S extends Agent<?, ?>> Atoms<S> merged(double[] w, List<double[]> points) {
        int[] group = groups(points);
        double[] sums = new double[w.length];
        for (int k = 0; k < w.length; k++) {
            sums[group[k]] += w[k];
        }
        List<double[]> kept = new ArrayList<>();
        double[] weights = new double[w.length];
        for (int k = 0; k < w.length; k++) {
            if (sums[group[k]] > 0) {
                weights[kept.size()] = sums[group[k]];
                sums[group[k]] = 0;
                kept.add(points.get(k));
            }
        }
        weights = Arrays.copyOf(weights, kept.size());
        Simplex.normalise(weights, weights.length);
        return new Atoms<>(weights, kept);
    }

    /** Whether no two can be equal. */
    private static boolean apart(double[] place, double reach) {
        double[] sorted = place.clone();
        Arrays.sort(sorted);
        for (int k = 1; k < sorted.length; k++) {
            if (sorted[k] - sorted[k - 1] <= reach) {
                return false;
            }
        }
        return true;
    }

    /** The exponent and fraction bits of a double, read as one number, are a piecewise linear logarithm to base 2. */
    private static double projection(double[] p) {
        double s = 0;
        for (int i = 0; i < p.length; i++) {
            s += Double.doubleToRawLongBits(Math.max(p[i], SMALLEST)) * 0x1p-52 * ((i + 1) * GOLDEN % 1);
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
