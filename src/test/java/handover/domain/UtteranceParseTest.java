package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.math.Vector3;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** MODEL 4.1: how an utterance is taken apart. */
class UtteranceParseTest {
    private static final Vocabulary WORDS = new Vocabulary(List.of(
            new TableObject("a", new Vector3(0, 1, 0), Map.of("red", 1.0, "ball", 1.0, "light-blue", 1.0), null),
            new TableObject("b", new Vector3(0, 1, 0), Map.of("blue", 1.0, "cup", 1.0, "größe", 1.0), null)), 0.2);

    @ParameterizedTest(name = "[{index}] \"{0}\"")
    @CsvSource(delimiter = '|', nullValues = "-", textBlock = """
            ''                                  | NONE | -         | -        | -
            '  ...  '                           | NONE | -         | -        | -
            yes                                 | YES  | -         | -        | -
            yeah, the red ball                  | YES  | red ball  | -        | the
            yep                                 | YES  | -         | -        | -
            yup yup                             | YES  | -         | -        | -
            Sure!                               | YES  | -         | -        | -
            that is correct                     | YES  | -         | -        | that is
            no                                  | NO   | -         | -        | -
            Nope.                               | NO   | -         | -        | -
            nah nah                             | NO   | -         | -        | -
            wrong, blue                         | NO   | blue      | -        | -
            yes no                              | NONE | -         | -        | -
            no the red one, yes                 | NONE | red       | -        | the one
            RED Ball                            | NONE | red ball  | -        | -
            red red red                         | NONE | red red red | -      | -
            red,ball;cup.blue                   | NONE | red ball cup blue | - | -
            the light-blue größe                | NONE | light-blue größe | - | the
            light blue                          | NONE | blue      | -        | light
            yesterday nobody noted reddish      | NONE | -         | -        | yesterday nobody noted reddish
            not red                             | NONE | -         | red      | -
            not the red one, the blue one       | NONE | blue      | red      | the one the one
            not the red one but the blue one    | NONE | blue      | red      | the one the one
            not the red one the blue one        | NONE | blue      | red      | the one the one
            not that red ball this blue cup     | NONE | blue cup  | red ball | that this
            not a red ball my cup               | NONE | cup       | red ball | a my
            not red the ball                    | NONE | -         | red ball | the
            not red ball. blue cup              | NONE | blue cup  | red ball | -
            NOT Red, Blue                       | NONE | blue      | red      | -
            blue not red                        | NONE | blue      | red      | -
            not red not blue, cup               | NONE | cup       | red blue | -
            not the red, not the blue, the cup  | NONE | cup       | red blue | the the the
            not the red not the blue the cup    | NONE | cup       | red blue | the the the
            no, not the red one                 | NO   | -         | red      | the one
            not correct                         | NONE | -         | -        | -
            not sure                            | NONE | -         | -        | -
            not wrong, yes                      | YES  | -         | -        | -
            not sure, no                        | NO   | -         | -        | -
            not but yes                         | YES  | -         | -        | -
            not, red                            | NONE | red       | -        | -
            but red                             | NONE | red       | -        | -
            red not                             | NONE | red       | -        | -
            yes red blue no                     | NONE | red blue  | -        | -
            what's that? the cup!               | NONE | cup       | -        | what's that the
            """)
    void parse(String text, Answer answer, String content, String negated, String unknown) {
        assertEquals(new Utterance(answer, list(content), list(negated), list(unknown)), Utterance.parse(text, WORDS));
    }

    private static List<String> list(String words) {
        return words == null ? List.of() : Arrays.asList(words.trim().split(" "));
    }

    @ParameterizedTest
    @ValueSource(strings = {"the \"red\" ball", "the 'red' ball", "the red- ball", "(red) ball", "red/ball",
        "red \u2014 ball", "\u201cred\u201d ball", "red\tball\n"})
    void punctuationAroundAWordIsNotPartOfIt(String text) {
        assertEquals(List.of("red", "ball"), Utterance.parse(text, WORDS).content(), text);
    }

    @Property(tries = 500, seed = "45")
    void anyTextIsReadWithoutHarm(@ForAll String text) {
        Utterance said = Utterance.parse(text, WORDS);
        assertTrue(WORDS.words().containsAll(said.content()), () -> "content outside V: " + said);
        assertTrue(WORDS.words().containsAll(said.negated()), () -> "negated outside V: " + said);
        assertTrue(said.unknown().stream().noneMatch(w -> WORDS.indexOf(w) >= 0), () -> "known as unknown: " + said);
        assertEquals(said, Utterance.parse(text.toLowerCase(Locale.ROOT), WORDS), "case matters");
    }

    @Property(tries = 300, seed = "46")
    void whatIsWrittenIsReadAgain(@ForAll Random random) {
        Utterance said = new Utterance(Answer.values()[random.nextInt(3)], some(WORDS.words(), random),
                some(WORDS.words(), random), some(List.of("zork", "the", "um"), random));
        assertEquals(said, Utterance.parse(said.text(), WORDS), () -> "as \"" + said.text() + "\"");
    }

    private static List<String> some(List<String> words, Random random) {
        return random.ints(random.nextInt(4), 0, words.size()).mapToObj(words::get).toList();
    }

    @Test
    void silenceHasNothing() {
        assertEquals(Utterance.SILENCE, Utterance.parse("", WORDS));
        assertEquals(false, Utterance.SILENCE.hasContent());
    }

    /** A recogniser may write an accent as a character of its own. */
    @Test
    void accentsMayComeApart() {
        TableObject tea = new TableObject("tea", new Vector3(0, 1, 0), Map.of("th\u00e9", 1.0, "gru\u0308n", 1.0), null);
        Vocabulary vocabulary = new Vocabulary(List.of(tea), 0.2);
        assertEquals(List.of("gr\u00fcn", "th\u00e9"), Utterance.parse("gr\u00fcn the\u0301", vocabulary).content());
    }
}
