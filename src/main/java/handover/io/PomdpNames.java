package handover.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** The states, acts or observations of a .POMDP file, to be called by name or number. Immutable. */
final class PomdpNames {
    private static final int NEAR = 2;
    private static final int SHOWN = 6;
    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]*");
    /** What the lexer of pomdp-solve takes for something else. */
    private static final Set<String> WORDS = Set.of("discount", "values", "states", "actions", "observations", "start", "T", "O", "R",
            "include", "exclude", "uniform", "identity", "reset", "reward", "cost");

    private final String what;
    private final List<String> names;
    private final Map<String, Integer> index = new HashMap<>();

    /** @param what one of them is, with its article */
    PomdpNames(String what, List<String> names) {
        this.what = what;
        this.names = List.copyOf(names);
        names.forEach(n -> index.put(n, index.size()));
    }

    /** Whether every program that reads the format takes this for a name. */
    static boolean nameable(String name) {
        return NAME.matcher(name).matches() && !WORDS.contains(name);
    }

    /** Reads a count or a list of names. */
    static PomdpNames read(PomdpTokens tokens, String what, String plural, int most) {
        PomdpTokens.Token first = tokens.peek();
        if (first.number()) {
            int count = first.count() ? Integer.parseInt(first.text()) : 0;
            if (count < 1 || count > most) {
                throw tokens.bad(first, "a number of " + plural + " from 1 to " + most + ", or their names");
            }
            tokens.next();
            return new PomdpNames(what, IntStream.range(0, count).mapToObj(Integer::toString).toList());
        }
        List<String> names = new ArrayList<>();
        Map<String, PomdpTokens.Token> seen = new HashMap<>();
        while (!tokens.peek().end() && !PomdpParser.begins(tokens)) {
            PomdpTokens.Token name = tokens.next();
            if (!NAME.matcher(name.text()).matches()) {
                throw tokens.bad(name, "the name of " + what + " (a letter, then letters, digits, _ and -)");
            } else if (seen.put(name.text(), name) != null) {
                throw tokens.problem(name, "expected each name once, got \"" + name.text() + "\" twice");
            }
            names.add(name.text());
        }
        if (names.isEmpty() || names.size() > most) {
            throw tokens.bad(first, "a number of " + plural + " from 1 to " + most + ", or their names");
        }
        return new PomdpNames(what, names);
    }

    List<String> names() {
        return names;
    }

    int size() {
        return names.size();
    }

    /** Reads one of them, by name or number. */
    int one(PomdpTokens tokens) {
        PomdpTokens.Token t = tokens.next();
        Integer i = index.get(t.text());
        if (i == null && t.count() && Integer.parseInt(t.text()) < names.size()) {
            i = Integer.parseInt(t.text());
        }
        if (i == null) {
            throw tokens.bad(t, what + " (" + shown() + ")", suggestion(t.text()));
        }
        return i;
    }

    /** Reads one of them, or * for all: -1. */
    int oneOrAll(PomdpTokens tokens) {
        return tokens.take("*") ? -1 : one(tokens);
    }

    private String suggestion(String text) {
        return names.stream().filter(n -> distance(n, text) <= Math.min(NEAR, n.length() - 1)).findFirst().map(n -> "; did you mean " + n + "?").orElse("");
    }

    /** The first of them. */
    private String shown() {
        return String.join(", ", names.subList(0, Math.min(SHOWN, names.size()))) + (names.size() > SHOWN ? ", ..." : "");
    }

    /** How many letters must be changed, added or left out (Levenshtein). */
    private static int distance(String a, String b) {
        int[] before = IntStream.rangeClosed(0, b.length()).toArray();
        for (int i = 1; i <= a.length(); i++) {
            int[] row = new int[b.length() + 1];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int same = Character.toLowerCase(a.charAt(i - 1)) == Character.toLowerCase(b.charAt(j - 1)) ? 0 : 1;
                row[j] = Math.min(before[j - 1] + same, 1 + Math.min(before[j], row[j - 1]));
            }
            before = row;
        }
        return before[b.length()];
    }
}
