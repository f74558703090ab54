package handover.io;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** The words of a .POMDP file, one after the other: colons stand alone, comments are left out. Used by one thread. */
final class PomdpTokens {
    private static final Pattern NUMBER = Pattern.compile("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");
    private static final double ROUNDING = 1e-9;
    private static final Pattern COUNT = Pattern.compile("[0-9]{1,9}");

    /**
     * One word.
     *
     * @param text empty for the end of the file
     * @param line from 1
     * @param column from 1
     */
    record Token(String text, int line, int column) {
        boolean is(String other) {
            return text.equals(other);
        }

        boolean end() {
            return text.isEmpty();
        }

        boolean number() {
            return NUMBER.matcher(text).matches();
        }

        boolean count() {
            return COUNT.matcher(text).matches();
        }
    }

    private final String file;
    private final List<Token> all = new ArrayList<>();
    private int at;
    private int numbers;

    PomdpTokens(String text, String file) {
        this.file = file;
        int line = 1;
        int column = 1;
        int i = 0;
        while (i < text.length()) {
            char c = text.charAt(i);
            int from = i;
            if (c == '#') {
                while (i < text.length() && text.charAt(i) != '\n') {
                    i++;
                }
            } else if (c == ':') {
                all.add(new Token(":", line, column));
                i++;
            } else if (Character.isWhitespace(c) || c == '\uFEFF') {
                i++;
            } else {
                while (i < text.length() && !Character.isWhitespace(text.charAt(i)) && ":#".indexOf(text.charAt(i)) < 0) {
                    i++;
                }
                add(new Token(text.substring(from, i), line, column));
            }
            line = c == '\n' ? line + 1 : line;
            column = c == '\n' ? 1 : column + i - from;
        }
        all.add(new Token("", line, column));
    }

    /** A sign may stand apart from its number: both are one word. */
    private void add(Token t) {
        Token sign = all.isEmpty() ? t : all.get(all.size() - 1);
        if ((sign.is("-") || sign.is("+")) && t.number() && "+-".indexOf(t.text.charAt(0)) < 0) {
            all.set(all.size() - 1, new Token(sign.text + t.text, sign.line, sign.column));
        } else {
            all.add(t);
        }
    }

    Token peek() {
        return all.get(at);
    }

    /** The word after the next one; the end if there is none. */
    Token second() {
        return all.get(Math.min(at + 1, all.size() - 1));
    }

    Token third() {
        return all.get(Math.min(at + 2, all.size() - 1));
    }

    Token next() {
        return all.get(at < all.size() - 1 ? at++ : at);
    }

    /** Takes the next word if it is this one. */
    boolean take(String text) {
        boolean there = peek().is(text);
        at += there ? 1 : 0;
        return there;
    }

    void expect(String text) {
        if (!take(text)) {
            throw bad(peek(), "\"" + text + "\"");
        }
    }

    double number(String what) {
        Token t = next();
        double value = t.number() ? Double.parseDouble(t.text) : Double.NaN;
        if (!Double.isFinite(value)) {
            throw bad(t, what);
        }
        numbers++;
        return value;
    }

    /** How often {@link #number} or {@link #probability} gave one. */
    int numbers() {
        return numbers;
    }

    /** A number from 0 to 1, up to rounding. */
    double probability(String what) {
        Token t = peek();
        double p = number(what);
        if (p < 0 || p > 1 + ROUNDING) {
            throw bad(t, what);
        }
        return p;
    }

    PomdpFileException bad(Token t, String expected) {
        return bad(t, expected, "");
    }

    PomdpFileException bad(Token t, String expected, String hint) {
        return problem(t, "expected " + expected + ", got " + (t.end() ? "the end of the file" : "\"" + t.text + "\"") + hint);
    }

    PomdpFileException problem(Token t, String problem) {
        return new PomdpFileException(file, t.line, t.column, problem);
    }
}
