package handover.solver;

import java.util.Arrays;

/**
 * A k-d tree with a bounding box for each node, over points in one flat array: the points are kept in the order of the tree, so
 * that a node is a range of rows, split in the middle, and only boxes are stored beside them. The lower bound of a box is
 * computed with the same operations in the same order as a distance, and rounding is monotone, so that it is never above the
 * computed distance of any point in the box: the search is exact in floating point. Rejected: a vantage-point tree (its triangle
 * inequality needs a margin for rounding, and one distance for each node visited); a library (none that is kept up keeps points
 * in flat arrays that can be read from a file as they are). Immutable, thread safe.
 */
final class PointTree {
    private static final int LEAF = 24;

    private final float[] points;
    private final int dimensions;
    private final int size;
    /** By node: the lowest, then the highest coordinates. */
    private final float[] boxes;
    /** By node: where its two halves are farthest apart, or overlap least; only decides which one is looked at first. */
    private final int[] dimension;
    private final float[] border;

    /**
     * @param points in the order of {@link #order}, none of them negative; not copied, must not be modified
     * @param dimensions an even number
     */
    PointTree(float[] points, int dimensions) {
        this.points = points;
        this.dimensions = dimensions;
        this.size = dimensions == 0 ? 0 : points.length / dimensions;
        int nodes = 1;
        for (int rows = size; rows > LEAF; rows = (rows + 1) / 2) {
            nodes = 2 * nodes + 1;
        }
        boxes = new float[nodes * 2 * dimensions];
        dimension = new int[nodes];
        border = new float[nodes];
        bound(0, 0, size);
    }

    int size() {
        return size;
    }

    /** The order of points in which a tree can be made of them: row r of the tree is to be point {@code order[r]}. */
    static int[] order(float[] points, int dimensions) {
        int n = points.length / dimensions;
        int[] order = new int[n];
        Arrays.setAll(order, i -> i);
        split(points, dimensions, order, 0, n, new long[n]);
        return order;
    }

    /** Splits by the coordinate with the widest range, ties by the points' numbers. */
    private static void split(float[] points, int dimensions, int[] order, int from, int to, long[] keys) {
        if (to - from <= LEAF) {
            return;
        }
        int widest = widest(points, dimensions, order, from, to);
        for (int r = from; r < to; r++) {
            // Coordinates are not negative, so that the order of their bits is their order.
            keys[r] = (long) Float.floatToIntBits(points[order[r] * dimensions + widest]) << 32 | order[r];
        }
        Arrays.sort(keys, from, to);
        for (int r = from; r < to; r++) {
            order[r] = (int) keys[r];
        }
        int middle = (from + to) >>> 1;
        split(points, dimensions, order, from, middle, keys);
        split(points, dimensions, order, middle, to, keys);
    }

    private static int widest(float[] points, int dimensions, int[] order, int from, int to) {
        int widest = 0;
        float most = -1;
        for (int k = 0; k < dimensions; k++) {
            float low = Float.POSITIVE_INFINITY;
            float high = Float.NEGATIVE_INFINITY;
            for (int r = from; r < to; r++) {
                float x = points[order[r] * dimensions + k];
                low = Math.min(low, x);
                high = Math.max(high, x);
            }
            if (high - low > most) {
                most = high - low;
                widest = k;
            }
        }
        return widest;
    }

    private void bound(int node, int from, int to) {
        int low = node * 2 * dimensions;
        int high = low + dimensions;
        if (to - from > LEAF) {
            int middle = (from + to) >>> 1;
            bound(2 * node + 1, from, middle);
            bound(2 * node + 2, middle, to);
            int left = low + (node + 1) * 2 * dimensions;
            int right = left + 2 * dimensions;
            float widest = Float.NEGATIVE_INFINITY;
            for (int k = 0; k < dimensions; k++) {
                float gap = boxes[right + k] - boxes[left + dimensions + k];
                if (gap > widest) {
                    widest = gap;
                    dimension[node] = k;
                    border[node] = (boxes[right + k] + boxes[left + dimensions + k]) / 2;
                }
                boxes[low + k] = Math.min(boxes[left + k], boxes[right + k]);
                boxes[high + k] = Math.max(boxes[left + dimensions + k], boxes[right + dimensions + k]);
            }
            return;
        }
        Arrays.fill(boxes, low, high, Float.POSITIVE_INFINITY);
        Arrays.fill(boxes, high, high + dimensions, Float.NEGATIVE_INFINITY);
        for (int r = from; r < to; r++) {
            for (int k = 0; k < dimensions; k++) {
                float x = points[r * dimensions + k];
                boxes[low + k] = Math.min(boxes[low + k], x);
                boxes[high + k] = Math.max(boxes[high + k], x);
            }
        }
    }

    /** Offers every point to {@code nearest} (modified) that may be among the nearest to {@code query}. */
    void search(float[] query, Neighbours nearest) {
        if (size > 0) {
            search(0, 0, size, query, nearest);
        }
    }

    private void search(int node, int from, int to, float[] query, Neighbours nearest) {
        if (to - from <= LEAF) {
            for (int r = from; r < to; r++) {
                nearest.offer(r, BeliefMetric.squared(query, 0, points, r * dimensions, dimensions, nearest.limit()));
            }
            return;
        }
        int middle = (from + to) >>> 1;
        int left = 2 * node + 1;
        if (query[dimension[node]] < border[node]) {
            search(left, from, middle, query, nearest);
            if (mayHold(left + 1, query, nearest.limit())) {
                search(left + 1, middle, to, query, nearest);
            }
        } else {
            search(left + 1, middle, to, query, nearest);
            if (mayHold(left, query, nearest.limit())) {
                search(left, from, middle, query, nearest);
            }
        }
    }

    /**
     * Whether a box may hold a point within the limit: the squared distance to the box, summed like
     * {@link BeliefMetric#squared}, is not above it.
     */
    private boolean mayHold(int node, float[] query, float limit) {
        int low = node * 2 * dimensions;
        int high = low + dimensions;
        float even = 0;
        float odd = 0;
        for (int k = 0; k < dimensions; k += 2) {
            float s = outside(boxes[low + k], query[k], boxes[high + k]);
            float t = outside(boxes[low + k + 1], query[k + 1], boxes[high + k + 1]);
            even += s * s;
            odd += t * t;
            if (even + odd > limit) {
                return false;
            }
        }
        return true;
    }

    private static float outside(float low, float q, float high) {
        return q < low ? low - q : q > high ? q - high : 0;
    }
}
