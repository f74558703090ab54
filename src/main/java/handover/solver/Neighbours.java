package handover.solver;

import java.util.Arrays;

/**
 * The k nearest rows that were offered so far and are not beyond a radius, nearest first; of rows equally far the one stored
 * first, by {@code ordinals}. If the query itself is stored, nothing else is a neighbour. Used by one thread.
 */
final class Neighbours {
    private final int[] ordinals;
    private final int[] rows;
    private final int[] images;
    private final float[] squared;
    private final float radius;
    private int size;
    private int image;
    private long seen;

    /**
     * @param ordinals by row; not modified
     * @param radius largest squared distance
     */
    Neighbours(int k, int[] ordinals, float radius) {
        this.ordinals = ordinals;
        this.radius = radius;
        rows = new int[k];
        images = new int[k];
        squared = new float[k];
    }

    /** What is offered from now on is found under this symmetry; a row counts once, under the one where it is nearest. */
    void under(int symmetry) {
        image = symmetry;
    }

    /** Squared distance beyond which nothing is kept. */
    float limit() {
        return size > 0 && squared[0] == 0 ? 0 : size < rows.length ? radius : squared[size - 1];
    }

    void offer(int row, float distance) {
        seen++;
        if (distance > limit() || image > 0 && !dropFarther(row, distance)) {
            return;
        }
        size = distance == 0 && size > 0 && squared[0] > 0 ? 0 : size;
        int at = size;
        while (at > 0 && before(row, distance, at - 1)) {
            at--;
        }
        if (at == rows.length) {
            return;
        }
        int moved = Math.min(size, rows.length - 1) - at;
        System.arraycopy(rows, at, rows, at + 1, moved);
        System.arraycopy(images, at, images, at + 1, moved);
        System.arraycopy(squared, at, squared, at + 1, moved);
        rows[at] = row;
        images[at] = image;
        squared[at] = distance;
        size = Math.min(size + 1, rows.length);
    }

    private boolean before(int row, float distance, int at) {
        return distance < squared[at] || distance == squared[at] && ordinals[row] < ordinals[rows[at]];
    }

    /** Whether the row is not yet there or was farther (then it is taken out). */
    private boolean dropFarther(int row, float distance) {
        for (int k = 0; k < size; k++) {
            if (rows[k] == row) {
                if (squared[k] <= distance) {
                    return false;
                }
                System.arraycopy(rows, k + 1, rows, k, size - k - 1);
                System.arraycopy(images, k + 1, images, k, size - k - 1);
                System.arraycopy(squared, k + 1, squared, k, size - k - 1);
                size--;
                return true;
            }
        }
        return true;
    }

    int size() {
        return size;
    }

    /** The row of the k-th nearest, from 0. */
    int row(int k) {
        return rows[k];
    }

    /** The symmetry under which it was found. */
    int image(int k) {
        return images[k];
    }

    double distance(int k) {
        return Math.sqrt(squared[k]);
    }

    /** How many rows were offered. */
    long seen() {
        return seen;
    }

    @Override
    public String toString() {
        return Arrays.toString(Arrays.copyOf(rows, size));
    }
}
