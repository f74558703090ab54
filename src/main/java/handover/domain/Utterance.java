package handover.domain;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What was said, taken apart (MODEL 4.1): an answer, words that describe the wanted object, words that describe what is
 * not wanted, and words that carry no information. Immutable.
 *
 * @param answer yes, no, or none (also if both were said)
 * @param content words of V, in the order in which they were said
 * @param negated words of V in the scope of "not"
 * @param unknown other words
 */
public record Utterance(Answer answer, List<String> content, List<String> negated, List<String> unknown) {
    /** Nothing was said. */
    public static final Utterance SILENCE = new Utterance(Answer.NONE, List.of(), List.of(), List.of());

    private static final Set<String> YES = Set.of("yes", "yeah", "yep", "yup", "sure", "correct");
    private static final Set<String> NO = Set.of("no", "nope", "nah", "wrong");
    private static final String NOT = "not";
    private static final String BUT = "but";
    private static final Set<String> DETERMINERS = Set.of("the", "a", "an", "this", "that", "these", "those", "my", "your",
            "his", "her", "its", "our", "their");
    private static final Pattern TOKEN = Pattern.compile("[\\p{L}\\p{N}](?:[\\p{L}\\p{M}\\p{N}'-]*[\\p{L}\\p{M}\\p{N}])?|[,.;:!?]");

    public Utterance {
        content = List.copyOf(content);
        negated = List.copyOf(negated);
        unknown = List.copyOf(unknown);
    }

    /** Whether a word is heard as an answer or as negation and so cannot describe an object. */
    static boolean isReserved(String word) {
        return YES.contains(word) || NO.contains(word) || word.equals(NOT) || word.equals(BUT);
    }

    /** The lower-case words of a text, without punctuation. */
    static List<String> tokens(String text) {
        return split(text).stream().filter(t -> Character.isLetterOrDigit(t.charAt(0))).toList();
    }

    /**
     * Takes a transcript apart. The scope of "not" ends at punctuation, at "but", or before the second determiner. An
     * answer word in that scope ("not correct", "not sure") is no answer.
     */
    public static Utterance parse(String text, Vocabulary vocabulary) {
        Set<Answer> answers = EnumSet.noneOf(Answer.class);
        List<String> content = new ArrayList<>();
        List<String> negated = new ArrayList<>();
        List<String> unknown = new ArrayList<>();
        boolean inScope = false;
        int determiners = 0;
        for (String token : split(text)) {
            if (token.equals(NOT)) {
                inScope = true;
                determiners = 0;
            } else if (token.equals(BUT) || !Character.isLetterOrDigit(token.charAt(0))) {
                inScope = false;
            } else if (isReserved(token)) {
                if (!inScope) {
                    answers.add(YES.contains(token) ? Answer.YES : Answer.NO);
                }
            } else {
                inScope = inScope && !(DETERMINERS.contains(token) && ++determiners == 2);
                boolean known = vocabulary.indexOf(token) >= 0;
                (known ? inScope ? negated : content : unknown).add(token);
            }
        }
        Answer answer = answers.size() == 1 ? answers.iterator().next() : Answer.NONE;
        return new Utterance(answer, content, negated, unknown);
    }

    /** Whether words of V were said that describe the wanted object. */
    public boolean hasContent() {
        return !content.isEmpty();
    }

    /** A transcript that {@link #parse} reads as this utterance. */
    public String text() {
        List<String> parts = new ArrayList<>();
        if (answer != Answer.NONE) {
            parts.add(answer.name().toLowerCase(Locale.ROOT));
        }
        parts.addAll(content);
        parts.addAll(unknown);
        if (!negated.isEmpty()) {
            parts.add(NOT);
            parts.addAll(negated);
        }
        return String.join(" ", parts);
    }

    /** The same text with letters and their accents composed (Unicode NFC), as words are compared. */
    static String normal(String text) {
        return Normalizer.normalize(text, Normalizer.Form.NFC);
    }

    private static List<String> split(String text) {
        List<String> tokens = new ArrayList<>();
        Matcher m = TOKEN.matcher(normal(text).toLowerCase(Locale.ROOT));
        while (m.find()) {
            tokens.add(m.group());
        }
        return tokens;
    }
}
