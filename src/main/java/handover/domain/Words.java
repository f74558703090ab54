package handover.domain;

import java.util.List;
import java.util.random.RandomGenerator;

/**
 * The tables p(w | i) of MODEL 4.1 for the objects of a scene, plain or in contrast to an open reference. Immutable,
 * thread safe; arrays must not be modified.
 */
public final class Words {
    /** By word, then object. */
    private final double[][] probability;
    /** By object, then word: sums of p(0..w | i). */
    private final double[][] cumulative;

    private Words(double[][] probability, int objects) {
        this.probability = probability;
        this.cumulative = new double[objects][probability.length];
        for (int i = 0; i < objects; i++) {
            double sum = 0;
            for (int w = 0; w < probability.length; w++) {
                sum += probability[w][i];
                cumulative[i][w] = sum;
            }
        }
    }

    static Words plain(Vocabulary vocabulary, List<TableObject> objects) {
        double[][] p = new double[vocabulary.size()][objects.size()];
        for (int w = 0; w < p.length; w++) {
            for (int i = 0; i < objects.size(); i++) {
                p[w][i] = vocabulary.probability(w, objects.get(i));
            }
        }
        return new Words(p, objects.size());
    }

    /**
     * p_eta: who wants something else than the act refers to says words less often that an object of the act also has.
     * Where that would leave no word at all the plain probabilities stay.
     */
    Words contrast(Vocabulary vocabulary, List<TableObject> objects, Act reference, double eta) {
        double[][] p = new double[probability.length][objects.size()];
        for (int i = 0; i < objects.size(); i++) {
            boolean referred = reference.objects().contains(objects.get(i).name());
            double rest = 0;
            for (int w = 0; w < p.length; w++) {
                boolean shared = !referred && uses(reference, objects, vocabulary.words().get(w));
                p[w][i] = probability[w][i] * (shared ? 1 - eta : 1);
                rest += p[w][i];
            }
            for (int w = 0; w < p.length; w++) {
                p[w][i] = referred || rest <= 0 ? probability[w][i] : p[w][i] / rest;
            }
        }
        return new Words(p, objects.size());
    }

    private static boolean uses(Act reference, List<TableObject> objects, String word) {
        return objects.stream().anyMatch(o -> reference.objects().contains(o.name()) && o.count(word) > 0);
    }

    /** p(word | i) for each object i, by the word's number in the vocabulary. */
    public double[] probabilities(int word) {
        return probability[word];
    }

    /** The number of a word drawn from p(w | i). Throws if there are no words. */
    public int sample(int i, RandomGenerator random) {
        double[] sums = cumulative[i];
        double u = random.nextDouble() * sums[sums.length - 1];
        int w = 0;
        while (w < sums.length - 1 && u >= sums[w]) {
            w++;
        }
        return w;
    }
}
