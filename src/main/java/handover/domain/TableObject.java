package handover.domain;

import handover.math.Vector3;
import java.util.Collections;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * One thing on the table that the human may want. Immutable.
 *
 * @param name unique on the table; letters, digits, '_', '-' or '.'
 * @param position metres, table frame
 * @param words the vocabulary that people use for it: word to count, each count &gt;= 0; may be empty
 * @param label what the robot calls it when it asks; default: the name with '_' read as a space
 */
public record TableObject(String name, Vector3 position, Map<String, Double> words, String label) {
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_.-]+");
    private static final Pattern WORD = Pattern.compile("[\\p{Ll}\\p{Lo}\\p{N}](?:[\\p{Ll}\\p{Lo}\\p{M}\\p{N}'-]*[\\p{Ll}\\p{Lo}\\p{M}\\p{N}])?");
    private static final double MOST = 1e9;

    /** Checks every field; throws {@link InvalidParameterException}. */
    public TableObject {
        if (name == null || !NAME.matcher(name).matches()) {
            throw new InvalidParameterException("name", name, "letters, digits, '_', '-' or '.'");
        }
        if (name.equals(HandoverState.CLASS_TASK)) {
            throw new InvalidParameterException("name", name, "another name, because a state calls what is known so");
        }
        Check.position("position", position);
        SortedMap<String, Double> sorted = new TreeMap<>();
        (words == null ? Map.<String, Double>of() : words).forEach((word, count) -> sorted.put(Utterance.normal(word), count));
        sorted.forEach((word, count) -> {
            String field = "words." + word;
            if (!WORD.matcher(word).matches()) {
                throw new InvalidParameterException(field, word, "one lower-case word");
            }
            if (Utterance.isReserved(word)) {
                throw new InvalidParameterException(field, word,
                        "a word that describes the object; this one is heard as an answer, as \"not\" or as \"but\"");
            }
            Check.present(field, count, "a count >= 0");
            Check.within(field, count, 0, MOST, "a count");
        });
        words = Collections.unmodifiableSortedMap(sorted);
        label = label == null || label.isBlank() ? name.replace('_', ' ') : label;
    }

    /** The same thing somewhere else. */
    public TableObject at(Vector3 elsewhere) {
        return new TableObject(name, elsewhere, words, label);
    }

    /** c(w), 0 for a word that is never used for it. */
    public double count(String word) {
        return words.getOrDefault(word, 0.0);
    }
}
