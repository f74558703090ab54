package handover.domain;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * V, the union of the words of the objects that the domain starts with, and p(w | i) of MODEL 4.1. Words are numbered in
 * alphabetical order. Immutable, thread safe.
 */
public final class Vocabulary {
    private final List<String> words;
    private final Map<String, Integer> index = new TreeMap<>();
    private final double alpha;

    /** @param alpha pseudo-count of each word for each object */
    public Vocabulary(List<TableObject> objects, double alpha) {
        TreeSet<String> all = new TreeSet<>();
        objects.forEach(o -> o.words().forEach((w, c) -> all.add(w)));
        this.words = List.copyOf(all);
        this.alpha = alpha;
        words.forEach(w -> index.put(w, index.size()));
    }

    public int size() {
        return words.size();
    }

    public List<String> words() {
        return words;
    }

    /** The number of a word, -1 if it is not in V. */
    public int indexOf(String word) {
        return index.getOrDefault(word, -1);
    }

    /** p(w | o) = (c_o(w) + alpha) / (C_o + alpha |V|); 0 for an object without words if alpha = 0. */
    public double probability(int word, TableObject o) {
        double total = alpha * words.size();
        for (Map.Entry<String, Double> e : o.words().entrySet()) {
            total += index.containsKey(e.getKey()) ? e.getValue() : 0;
        }
        return total == 0 ? 0 : (o.count(words.get(word)) + alpha) / total;
    }
}
