package handover.solver;

import handover.domain.HumanModel;
import handover.domain.Scene;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/**
 * Gestures drawn in advance, with their likelihoods for every object of a scene, so that a search need not compute angles
 * again and again: for each object a pool of at most 1,024 draws. Immutable, thread safe.
 */
final class Evidence {
    private static final int MOST_ENTRIES = 1 << 20;
    private static final int MOST_DRAWS = 1024;
    private static final int FEWEST_DRAWS = 16;
    private static final long SEED = 1;

    /** By object that is meant, then draw, then object. */
    private final double[][][] likelihoods;

    Evidence(Scene scene) {
        int n = scene.size();
        int draws = Math.max(FEWEST_DRAWS, Math.min(MOST_DRAWS, MOST_ENTRIES / (n * n)));
        likelihoods = new double[n][draws][];
        for (int i = 0; i < n; i++) {
            RandomGenerator random = new SplittableRandom(SEED + i);
            for (int k = 0; k < draws; k++) {
                likelihoods[i][k] = HumanModel.gestureDensities(scene, HumanModel.sampleGesture(scene, i, random));
            }
        }
    }

    /** p(gesture | j) for each j, of the gesture at {@code u} in [0, 1) of those that mean object {@code i}; not to be modified. */
    double[] gesture(int i, double u) {
        return likelihoods[i][(int) (u * likelihoods[i].length)];
    }
}
