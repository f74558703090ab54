package handover.simulation;

import handover.math.MatchScore;
import handover.math.Simplex;

/**
 * What a match score makes the robot want the human to believe: the h that maximises S(b, h), found numerically. Reproduces
 * the argument of the report, section 2.3: the linear score wants all mass on the likeliest object, the proper scores want
 * the human to believe what the robot does. Pure, thread safe.
 */
public final class BestExpectation {
    private static final double FINEST = 1e-9;

    private BestExpectation() {}

    /**
     * The best h, by moving ever smaller amounts of mass between two objects, from b, from uniform, and from each vertex.
     *
     * @param b the robot's belief, not modified
     * @return a distribution over the same objects
     */
    public static double[] of(MatchScore score, double[] b) {
        int n = b.length;
        double[] best = climb(score, b, b.clone());
        double[] other = climb(score, b, Simplex.uniform(n));
        best = score.of(b, other, n) > score.of(b, best, n) ? other : best;
        for (int i = 0; i < n; i++) {
            other = climb(score, b, Simplex.vertex(n, i));
            best = score.of(b, other, n) > score.of(b, best, n) ? other : best;
        }
        return best;
    }

    private static double[] climb(MatchScore score, double[] b, double[] h) {
        for (double amount = 0.5; amount > FINEST; amount /= 2) {
            boolean moved = true;
            while (moved) {
                moved = false;
                for (int i = 0; i < h.length; i++) {
                    for (int j = 0; j < h.length; j++) {
                        moved |= i != j && move(score, b, h, i, j, Math.min(amount, h[i]));
                    }
                }
            }
        }
        return h;
    }

    /** Moves mass (modifies h) from i to j if that raises the score. */
    private static boolean move(MatchScore score, double[] b, double[] h, int i, int j, double amount) {
        if (amount < FINEST) {
            return false;
        }
        double before = score.of(b, h, h.length);
        double from = h[i];
        double to = h[j];
        h[i] = from - amount;
        h[j] = to + amount;
        if (score.of(b, h, h.length) > before + 1e-15) {
            return true;
        }
        h[i] = from;
        h[j] = to;
        return false;
    }
}
