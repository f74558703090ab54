package handover.solver;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What follows the colon in the specification of a solver. Immutable.
 *
 * @param spec as written
 * @param values by key
 */
public record SolverParameters(String spec, Map<String, String> values) {
    /**
     * Reads {@code NAME:key=value,key=value}.
     *
     * @throws Solvers.BadSolverException if there are other keys than these
     */
    public static SolverParameters of(String name, List<String> keys, String spec) {
        Map<String, String> values = new TreeMap<>();
        String list = spec.length() == name.length() ? "" : spec.substring(name.length() + 1);
        String known = keys.isEmpty() ? name + " has no parameters"
                : "expected key=value with keys from " + String.join(", ", keys);
        if (list.isEmpty() && spec.length() > name.length()) {
            throw new Solvers.BadSolverException(spec, known + ", got nothing after the colon", null);
        }
        for (String part : list.isEmpty() ? new String[0] : list.split(",", -1)) {
            String[] pair = part.split("=", 2);
            if (pair.length < 2 || !keys.contains(pair[0])) {
                throw new Solvers.BadSolverException(spec, known + ", got \"" + part + "\"", null);
            } else if (values.put(pair[0], pair[1]) != null) {
                throw new Solvers.BadSolverException(spec, "expected " + pair[0] + " once, got it twice", null);
            }
        }
        return new SolverParameters(spec, values);
    }

    /** A whole number from 1 to {@code most}. */
    public int count(String key, int otherwise, int most) {
        String text = values.getOrDefault(key, Integer.toString(otherwise));
        int value = text.matches("[0-9]{1,9}") ? Integer.parseInt(text) : 0;
        if (value < 1 || value > most) {
            throw bad(key, "a whole number from 1 to " + most, text);
        }
        return value;
    }

    /** A probability. */
    public double probability(String key, double otherwise) {
        return number(key, otherwise, 1, "a probability in [0, 1]");
    }

    /** A finite number of at least 0; {@code what} says of what, for the message. */
    public double amount(String key, double otherwise, String what) {
        return number(key, otherwise, Double.MAX_VALUE, what + ", at least 0");
    }

    private double number(String key, double otherwise, double most, String expected) {
        String text = values.getOrDefault(key, Double.toString(otherwise));
        try {
            double value = Double.parseDouble(text);
            if (value >= 0 && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw bad(key, expected, text);
        }
        throw bad(key, expected, text);
    }

    /** One of some words, of which the first is the default. */
    public String choice(String key, String... words) {
        String text = values.getOrDefault(key, words[0]);
        if (!new TreeSet<>(List.of(words)).contains(text)) {
            throw bad(key, String.join(" or ", words), text);
        }
        return text;
    }

    private Solvers.BadSolverException bad(String key, String expected, String got) {
        return new Solvers.BadSolverException(spec, key + ": expected " + expected + ", got \"" + got + "\"", null);
    }
}
