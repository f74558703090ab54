package handover.theory;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * Reduces weighted beliefs to fewer without bias and with the least expected squared change of the weights: with the c
 * that solves sum_k min(w_k / c, 1) = limit, weights of at least c stay, the others survive with probability w_k / c,
 * chosen by one systematic draw, and then weigh c.
 *
 * <p>Source: Fearnhead and Clifford, 2003, section 3.2.
 */
final class Resampling {
    private Resampling() {}

    /** At most {@code limit} (+1 by rounding) of the atoms; there must be more. */
    static <S extends Agent<?, ?>> Atoms<S> reduced(Atoms<S> atoms, int limit, RandomGenerator random) {
        double[] w = atoms.weights();
        double c = threshold(w, limit);
        List<double[]> kept = new ArrayList<>(limit + 1);
        double[] weights = new double[w.length];
        double u = c * random.nextDouble();
        for (int k = 0; k < w.length; k++) {
            if (w[k] >= c) {
                weights[kept.size()] = w[k];
                kept.add(atoms.points().get(k));
            } else if ((u -= w[k]) < 0) {
                u += c;
                weights[kept.size()] = c;
                kept.add(atoms.points().get(k));
            }
        }
        weights = Arrays.copyOf(weights, kept.size());
        double sum = Arrays.stream(weights).sum();
        return new Atoms<>(Arrays.stream(weights).map(x -> x / sum).toArray(), kept);
    }

    /** c with sum_k min(w_k / c, 1) = limit: the heaviest ones are set apart until the rest is lighter than its share. */
    static double threshold(double[] w, int limit) {
        double[] sorted = w.clone();
        Arrays.sort(sorted);
        double rest = Arrays.stream(sorted).sum();
        int heavy = 0;
        while (heavy < limit - 1 && sorted[w.length - 1 - heavy] * (limit - heavy) >= rest) {
            rest -= sorted[w.length - 1 - heavy];
            heavy++;
        }
        return rest / (limit - heavy);
    }
}
