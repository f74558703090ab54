package handover.solver;

import handover.domain.HumanModel;
import handover.domain.Scene;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.random.RandomGenerator;

/**
 * Gestures drawn in advance, with their likelihoods for every object of a scene, so that a search need not compute angles
 * again and again: for each object a pool of at most 1,024 draws. Immutable to the outside, thread safe.
 */
final class Evidence {
    private static final int MOST_ENTRIES = 1 << 20;
    private static final int MOST_DRAWS = 1024;
    private static final int FEWEST_DRAWS = 16;
    private static final long SEED = 1;

    private final Scene scene;
    private final int draws;
    /** By object that is meant, then draw, then object; filled on demand, with the same values whoever does it. */
    private final AtomicReferenceArray<double[][]> likelihoods;

    Evidence(Scene scene) {
        this.scene = scene;
        int n = scene.size();
        draws = Math.max(FEWEST_DRAWS, Math.min(MOST_DRAWS, MOST_ENTRIES / (n * n)));
        likelihoods = new AtomicReferenceArray<>(n);
    }

    /** p(gesture | j) for each j, of the gesture at {@code u} in [0, 1) of those that mean object {@code i}; not to be modified. */
    double[] gesture(int i, double u) {
        double[][] pool = likelihoods.get(i);
        if (pool == null) {
            pool = draw(i);
            likelihoods.set(i, pool);
        }
        return pool[(int) (u * draws)];
    }

    private double[][] draw(int i) {
        RandomGenerator random = new SplittableRandom(SEED + i);
        double[][] pool = new double[draws][];
        for (int k = 0; k < draws; k++) {
            pool[k] = HumanModel.gestureDensities(scene, HumanModel.sampleGesture(scene, i, random));
        }
        return pool;
    }
}
