package handover.io;

import handover.tabular.TabularBuilder;
import handover.tabular.TabularPomdp;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Reads one .POMDP file. Used once, by one thread.
 *
 * <p>Source: A. R. Cassandra's file format of pomdp-solve, with its grammar.
 */
final class PomdpParser {
    private static final Set<String> STATEMENTS = Set.of("discount", "values", "states", "actions", "observations", "start", "T", "O",
            "R");
    private static final Set<String> LISTS = Set.of("start", "T", "O", "R");
    private static final int MOST_NAMES = 1_000_000;

    private final PomdpTokens tokens;
    private final Map<String, PomdpTokens.Token> given = new HashMap<>();
    private double discount;
    private double sign = 1;
    private PomdpNames states;
    private PomdpNames acts;
    private PomdpNames observations;
    private double[] start;
    private TabularBuilder to;
    /** Where each row of probabilities was last touched. */
    private final Map<TabularBuilder.BadRow, PomdpTokens.Token> touched = new HashMap<>();
    /** Rows of T that are the start, which may still come, and their next states that were set since. */
    private final Map<ResetRow, BitSet> resets = new HashMap<>();
    /** The statement that began last; null at first. */
    private PomdpTokens.Token latest;
    /** How many numbers were read before that statement. */
    private int numbers;

    private record ResetRow(int act, int state) {}

    PomdpParser(String text, String file) {
        tokens = new PomdpTokens(text, file);
    }

    /** Whether a statement begins here. */
    static boolean begins(PomdpTokens tokens) {
        String word = tokens.peek().text();
        return STATEMENTS.contains(word) && tokens.second().is(":") || startList(tokens);
    }

    private static boolean startList(PomdpTokens tokens) {
        return tokens.peek().is("start") && (tokens.second().is("include") || tokens.second().is("exclude")) && tokens.third().is(":");
    }

    TabularPomdp parse() {
        while (!tokens.peek().end()) {
            statement();
        }
        prepare();
        return finish();
    }

    private void statement() {
        PomdpTokens.Token word = tokens.peek();
        if (!begins(tokens)) {
            if (word.number() && latest != null && LISTS.contains(latest.text())) {
                throw tokens.problem(word, tooMany(word));
            }
            throw tokens.bad(STATEMENTS.contains(word.text()) ? tokens.second() : word,
                    STATEMENTS.contains(word.text()) ? "\":\"" : "discount, values, states, actions, observations, start, T, O or R");
        }
        latest = word;
        numbers = tokens.numbers();
        boolean list = startList(tokens);
        tokens.next();
        String kind = list ? tokens.next().text() : "";
        tokens.expect(":");
        switch (word.text()) {
            case "T" -> transition(word);
            case "O" -> observation(word);
            case "R" -> reward();
            case "start" -> {
                once(word);
                start(kind);
            }
            default -> preamble(word);
        }
    }

    /** Of a number where a statement should begin. */
    private String tooMany(PomdpTokens.Token number) {
        int taken = tokens.numbers() - numbers;
        return "expected a statement, got \"" + number.text() + "\"; the " + latest.text() + " that began on line " + latest.line() + " takes "
                + (taken == 0 ? "no number" : taken == 1 ? "1 number" : taken + " numbers") + ", this is one too many";
    }

    private void once(PomdpTokens.Token word) {
        PomdpTokens.Token before = given.put(word.text(), word);
        if (before != null) {
            throw tokens.problem(word, "expected " + word.text() + " once, got it on line " + before.line() + " already");
        }
    }

    private void preamble(PomdpTokens.Token word) {
        once(word);
        if (to != null) {
            throw tokens.problem(word, "expected " + word.text() + " before all T, O and R");
        }
        switch (word.text()) {
            case "discount" -> discount = tokens.probability("a discount in [0, 1]");
            case "values" -> {
                PomdpTokens.Token value = tokens.next();
                if (!value.is("reward") && !value.is("cost")) {
                    throw tokens.bad(value, "reward or cost");
                }
                sign = value.is("cost") ? -1 : 1;
            }
            case "states" -> states = PomdpNames.read(tokens, "a state", "states", MOST_NAMES);
            case "actions" -> acts = PomdpNames.read(tokens, "an action", "actions", MOST_NAMES);
            default -> observations = PomdpNames.read(tokens, "an observation", "observations", MOST_NAMES);
        }
    }

    private void start(String kind) {
        if (states == null) {
            throw tokens.problem(given.get("start"), "expected states before start");
        }
        start = new double[states.size()];
        if (!kind.isEmpty()) {
            startList(kind);
        } else if (tokens.take("uniform")) {
            Arrays.fill(start, 1.0 / start.length);
        } else if (!tokens.peek().number() || start.length > 1 && tokens.peek().count() && !tokens.second().number()) {
            start[states.one(tokens)] = 1;
        } else {
            for (int s = 0; s < start.length; s++) {
                start[s] = tokens.probability("a probability for each of the " + start.length + " states");
            }
        }
    }

    private void startList(String kind) {
        boolean[] named = new boolean[start.length];
        PomdpTokens.Token first = tokens.peek();
        int count = 0;
        do {
            int s = states.one(tokens);
            count += named[s] ? 0 : 1;
            named[s] = true;
        } while (!tokens.peek().end() && !begins(tokens));
        boolean include = kind.equals("include");
        int left = include ? count : start.length - count;
        if (left == 0) {
            throw tokens.problem(first, "expected at least one state that is not excluded");
        }
        for (int s = 0; s < start.length; s++) {
            start[s] = named[s] == include ? 1.0 / left : 0;
        }
    }

    /** Once the preamble is through. */
    private void prepare() {
        if (to != null) {
            return;
        }
        for (String word : List.of("discount", "states", "actions", "observations")) {
            if (!given.containsKey(word)) {
                throw tokens.bad(tokens.peek(), "\"" + word + ":\" before T, O and R");
            }
        }
        try {
            to = new TabularBuilder(discount, states.names(), acts.names(), observations.names());
        } catch (IllegalArgumentException e) {
            throw tokens.problem(given.get("states"), e.getMessage());
        }
    }

    private static int first(int i) {
        return Math.max(0, i);
    }

    private static int last(int i, PomdpNames of) {
        return i < 0 ? of.size() - 1 : i;
    }

    private interface Cell {
        void set(int a, int row, int column, double p);
    }

    private void transition(PomdpTokens.Token at) {
        prepare();
        probabilities(at, TabularBuilder.Kind.TRANSITION, states, (a, s, next, p) -> {
            to.transition(a, s, next, p);
            if (!resets.isEmpty()) {
                resets.computeIfPresent(new ResetRow(a, s), (row, set) -> with(set, next));
            }
        });
    }

    private static BitSet with(BitSet set, int i) {
        set.set(i);
        return set;
    }

    private void observation(PomdpTokens.Token at) {
        prepare();
        probabilities(at, TabularBuilder.Kind.OBSERVATION, observations, (a, s, o, p) -> to.observation(a, s, o, p));
    }

    /** What follows "T:" or "O:": an entry, a row or a matrix. */
    private void probabilities(PomdpTokens.Token at, TabularBuilder.Kind kind, PomdpNames columns, Cell cell) {
        int a = acts.oneOrAll(tokens);
        int row = tokens.take(":") ? states.oneOrAll(tokens) : -2;
        int column = row > -2 && tokens.take(":") ? columns.oneOrAll(tokens) : -2;
        if (column > -2) {
            double p = tokens.probability("a probability");
            each(kind, at, a, row, (i, s) -> {
                for (int c = first(column); c <= last(column, columns); c++) {
                    cell.set(i, s, c, p);
                }
            });
            return;
        }
        if (row > -2 && kind == TabularBuilder.Kind.TRANSITION && tokens.take("reset")) {
            each(kind, at, a, row, (i, s) -> resets.put(new ResetRow(i, s), new BitSet()));
            return;
        }
        int rows = row > -2 ? 1 : states.size();
        double[][] matrix = matrix(rows, columns.size(), row == -2 && columns.size() == states.size());
        each(kind, at, a, row, (i, s) -> {
            for (int c = 0; c < columns.size(); c++) {
                cell.set(i, s, c, matrix[rows == 1 ? 0 : s][c]);
            }
        });
    }

    private interface Row {
        void at(int a, int s);
    }

    private void each(TabularBuilder.Kind kind, PomdpTokens.Token at, int a, int row, Row action) {
        for (int i = first(a); i <= last(a, acts); i++) {
            for (int s = first(row); s <= last(row, states); s++) {
                action.at(i, s);
                touched.put(new TabularBuilder.BadRow(kind, i, s, 0), at);
            }
        }
    }

    private double[][] matrix(int rows, int columns, boolean identity) {
        double[][] p = new double[rows][columns];
        if (tokens.take("uniform")) {
            for (double[] row : p) {
                Arrays.fill(row, 1.0 / columns);
            }
        } else if (identity && tokens.take("identity")) {
            for (int i = 0; i < rows; i++) {
                p[i][i] = 1;
            }
        } else {
            String words = identity ? ", or uniform or identity" : ", or uniform";
            for (int i = 0; i < rows; i++) {
                for (int c = 0; c < columns; c++) {
                    p[i][c] = tokens.probability("a probability, " + (rows == 1 ? "" : rows + " rows of ") + columns + " in all"
                            + (i + c == 0 ? words : ""));
                }
            }
        }
        return p;
    }

    private static double[] uniform(int n) {
        double[] p = new double[n];
        Arrays.fill(p, 1.0 / n);
        return p;
    }

    private void reward() {
        prepare();
        PomdpTokens.Token at = tokens.peek();
        int a = acts.oneOrAll(tokens);
        tokens.expect(":");
        int s = states.oneOrAll(tokens);
        if (!tokens.take(":")) {
            for (int next = 0; next < states.size(); next++) {
                for (int o = 0; o < observations.size(); o++) {
                    reward(at, a, s, next, o, tokens.number("a reward for each next state and observation"));
                }
            }
            return;
        }
        int next = states.oneOrAll(tokens);
        if (tokens.take(":")) {
            int o = observations.oneOrAll(tokens);
            reward(at, a, s, next, o, tokens.number("a reward"));
            return;
        }
        for (int o = 0; o < observations.size(); o++) {
            reward(at, a, s, next, o, tokens.number("a reward for each observation"));
        }
    }

    private void reward(PomdpTokens.Token at, int a, int s, int next, int o, double r) {
        try {
            for (int i = first(a); i <= last(a, acts); i++) {
                to.reward(i, s, next, o, sign * r);
            }
        } catch (IllegalArgumentException e) {
            throw tokens.problem(at, e.getMessage());
        }
    }

    private TabularPomdp finish() {
        double[] b0 = start == null ? uniform(states.size()) : start;
        to.start(b0);
        resets.forEach((row, set) -> {
            for (int next = set.nextClearBit(0); next < b0.length; next = set.nextClearBit(next + 1)) {
                to.transition(row.act, row.state, next, b0[next]);
            }
        });
        TabularBuilder.BadRow bad = to.badRow();
        if (bad != null) {
            PomdpTokens.Token where = bad.kind() == TabularBuilder.Kind.START ? given.get("start")
                    : touched.getOrDefault(new TabularBuilder.BadRow(bad.kind(), bad.act(), bad.state(), 0), tokens.peek());
            throw tokens.problem(where, to.describe(bad) + ": expected probabilities that sum to 1, got a sum of " + bad.sum());
        }
        return to.build();
    }
}
