package handover.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** The search finds what going through all points finds, to the last bit and tie. */
class PointTreeTest {

    @Property(tries = 400, seed = "5")
    void findsWhatBruteForceFinds(@ForAll long seed, @ForAll @IntRange(min = 1, max = 700) int n, @ForAll @IntRange(min = 1, max = 7) int half,
            @ForAll @IntRange(min = 1, max = 12) int k, @ForAll boolean coarse) {
        SplittableRandom random = new SplittableRandom(seed);
        int dimensions = 2 * half;
        float[] points = points(random, n * dimensions, coarse);
        float radius = random.nextInt(3) == 0 ? Float.POSITIVE_INFINITY : (float) random.nextDouble();
        check(points, dimensions, k, radius, points(random, dimensions, coarse));
        float[] stored = Arrays.copyOfRange(points, 0, dimensions);
        check(points, dimensions, k, radius, stored);
    }

    @Test
    void manyPointsAlike() {
        float[] points = new float[5000 * 4];
        Arrays.fill(points, 0.25f);
        points[4 * 4321] = 0.5f;
        check(points, 4, 7, Float.POSITIVE_INFINITY, new float[] {0.25f, 0.25f, 0.25f, 0.25f});
        check(points, 4, 7, Float.POSITIVE_INFINITY, new float[] {1, 0.25f, 0.25f, 0.25f});
    }

    @Test
    void emptyAndSingle() {
        check(new float[0], 4, 2, Float.POSITIVE_INFINITY, new float[4]);
        check(new float[] {1, 2, 3, 4}, 4, 2, Float.POSITIVE_INFINITY, new float[4]);
    }

    @Test
    void looksAtASmallPartOfThePoints() {
        SplittableRandom random = new SplittableRandom(7);
        float[] points = points(random, 20_000 * 4, false);
        Neighbours nearest = search(points, 4, 1, Float.POSITIVE_INFINITY, points(random, 4, false));
        assertTrue(nearest.seen() < 1000, "looked at " + nearest.seen());
    }

    private static float[] points(SplittableRandom random, int count, boolean coarse) {
        float[] points = new float[count];
        for (int i = 0; i < count; i++) {
            points[i] = coarse ? random.nextInt(3) / 2f : (float) random.nextDouble();
        }
        return points;
    }

    /** Rows and ordinals are those of the unordered points. */
    private static Neighbours search(float[] points, int dimensions, int k, float radius, float[] query) {
        int[] order = PointTree.order(points, dimensions);
        float[] ordered = new float[points.length];
        for (int r = 0; r < order.length; r++) {
            System.arraycopy(points, order[r] * dimensions, ordered, r * dimensions, dimensions);
        }
        Neighbours nearest = new Neighbours(k, order, radius);
        new PointTree(ordered, dimensions).search(query, nearest);
        return nearest;
    }

    private static void check(float[] points, int dimensions, int k, float radius, float[] query) {
        int n = points.length / dimensions;
        int[] order = PointTree.order(points, dimensions);
        assertArrayEquals(IntStream.range(0, n).toArray(), Arrays.stream(order).sorted().toArray());
        float[] distance = new float[n];
        for (int i = 0; i < n; i++) {
            distance[i] = BeliefMetric.squared(query, 0, points, i * dimensions, dimensions, Float.POSITIVE_INFINITY);
        }
        boolean stored = IntStream.range(0, n).anyMatch(i -> distance[i] == 0);
        int[] expected = IntStream.range(0, n).boxed().filter(i -> distance[i] <= (stored ? 0 : radius))
                .sorted(Comparator.<Integer>comparingDouble(i -> distance[i]).thenComparing(i -> i)).limit(k).mapToInt(i -> i).toArray();
        Neighbours nearest = search(points, dimensions, k, radius, query);
        int[] found = IntStream.range(0, nearest.size()).map(j -> order[nearest.row(j)]).toArray();
        assertArrayEquals(expected, found);
        for (int j = 0; j < found.length; j++) {
            assertEquals(Math.sqrt(distance[found[j]]), nearest.distance(j));
        }
    }
}
