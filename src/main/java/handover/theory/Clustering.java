package handover.theory;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Merges near beliefs. Centres are chosen one after the other, first the heaviest belief, then always the one whose weight
 * times squared distance to the nearest centre is largest; every belief joins its nearest centre. Cost: atoms times limit.
 *
 * <p>Source: Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985, with weights; the Hellinger
 * distance ||sqrt p - sqrt q|| because an update stretches differences between small probabilities.
 */
public final class Clustering {
    private Clustering() {}

    /** At most {@code limit} atoms with the same mean. */
    static <S extends Agent<?, ?>> Atoms<S> reduced(Atoms<S> atoms, int limit) {
        return means(atoms, groups(atoms.weights(), atoms.points(), limit));
    }

    /** To which of at most {@code limit} clusters, counted from 0, each belief belongs; the arguments are not modified. */
    public static int[] groups(double[] w, List<double[]> points, int limit) {
        double[][] roots = points.stream().map(Clustering::roots).toArray(double[][]::new);
        double[] distance = new double[w.length];
        Arrays.fill(distance, Double.POSITIVE_INFINITY);
        int[] cluster = new int[w.length];
        int centre = 0;
        for (int k = 1; k < w.length; k++) {
            centre = w[k] > w[centre] ? k : centre;
        }
        for (int count = 0; count < limit && centre >= 0; count++) {
            join(roots, centre, count, distance, cluster);
            centre = worst(w, distance);
        }
        return cluster;
    }

    private static double[] roots(double[] p) {
        return Arrays.stream(p).map(Math::sqrt).toArray();
    }

    private static void join(double[][] roots, int centre, int number, double[] distance, int[] cluster) {
        for (int k = 0; k < roots.length; k++) {
            double d = 0;
            for (int i = 0; i < roots[k].length && d < distance[k]; i++) {
                double x = roots[k][i] - roots[centre][i];
                d += x * x;
            }
            if (d < distance[k]) {
                distance[k] = d;
                cluster[k] = number;
            }
        }
    }

    /** The belief that is represented worst; -1 if all are centres. */
    private static int worst(double[] w, double[] distance) {
        int worst = -1;
        double cost = 0;
        for (int k = 0; k < w.length; k++) {
            if (w[k] * distance[k] > cost) {
                cost = w[k] * distance[k];
                worst = k;
            }
        }
        return worst;
    }

    private static <S extends Agent<?, ?>> Atoms<S> means(Atoms<S> atoms, int[] cluster) {
        int count = Arrays.stream(cluster).max().orElse(-1) + 1;
        double[] weights = new double[count];
        double[][] means = new double[count][atoms.size()];
        for (int k = 0; k < cluster.length; k++) {
            double w = atoms.weights()[k];
            weights[cluster[k]] += w;
            for (int i = 0; i < atoms.size(); i++) {
                means[cluster[k]][i] += w * atoms.points().get(k)[i];
            }
        }
        List<double[]> points = new ArrayList<>();
        for (int c = 0; c < count; c++) {
            double total = Arrays.stream(means[c]).sum();
            points.add(Arrays.stream(means[c]).map(x -> x / total).toArray());
        }
        return new Atoms<>(weights, points);
    }
}
