package handover.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.tabular.TabularBuilder;
import handover.tabular.TabularPomdp;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every form of the format, what is wrong with a file and where, and the way there and back. */
class PomdpFilesTest {
    private static final String HEAD = "discount: 0.9\nvalues: reward\nstates: a b\nactions: go stay\nobservations: x y z\n";
    /** A name, and the words that are none, in the lexer of pomdp-solve. */
    private static final String LEXER_NAME = "[a-zA-Z]([a-zA-Z0-9]|[_-])*";
    private static final Set<String> LEXER_WORDS = Set.of("discount", "values", "states", "actions", "observations", "T", "O", "R", "uniform",
            "identity", "reward", "cost", "start", "include", "exclude", "reset");
    private static final String BODY = "T: * identity\nO: * uniform\n";

    private static TabularPomdp parse(String text) {
        return PomdpFiles.parse(text, "f");
    }

    private static double[] transitions(TabularPomdp m, int a, int s) {
        double[] p = new double[m.states().size()];
        for (int k = 0; k < p.length; k++) {
            p[k] = m.transition(a, s, k);
        }
        return p;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            start: uniform | 0.5 | 0.5
            start: 0.25 0.75 | 0.25 | 0.75
            start: b | 0 | 1
            start: 0 | 1 | 0
            start include: b a b | 0.5 | 0.5
            start exclude: 0 | 0 | 1
            # nothing is said | 0.5 | 0.5
            """)
    void startForms(String line, double a, double b) {
        assertArrayEquals(new double[] {a, b}, parse(HEAD + line + "\n" + BODY).start());
        assertArrayEquals(new double[] {a, b}, parse(HEAD + BODY + line + "\n").start());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            T: go : a : b 1 T: go : a : a 0 | 0 | 1
            T:go:0:* 0.5 | 0.5 | 0.5
            T: go : a 0.3 0.7 | 0.3 | 0.7
            T: go : a + 0.3 +0.7 | 0.3 | 0.7
            T: 0 : a uniform | 0.5 | 0.5
            T: go : * .1 9e-1 | 0.1 | 0.9
            T: go 0.2 0.8 1 0 | 0.2 | 0.8
            T: go uniform | 0.5 | 0.5
            T: * : a reset | 0 | 1
            T: go : a 0.3 0.7 T: * identity | 1 | 0
            """)
    void transitionForms(String text, double a, double b) {
        assertArrayEquals(new double[] {a, b}, transitions(parse(HEAD + "start: b\n" + BODY + text), 0, 0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            T: * : a reset | 0.25 | 0.75
            T: go : * reset | 0.25 | 0.75
            T: go : a reset T: go : a : b 0.5 T: go : a : a 0.5 | 0.5 | 0.5
            T: go : a reset T: * : a : b 0.75 T: stay : a : a 0.25 | 0.25 | 0.75
            T: go : a : b 1 T: go : a reset | 0.25 | 0.75
            T: go : a reset T: go : a 1 0 | 1 | 0
            T: go : a reset T: go uniform T: stay : a reset | 0.5 | 0.5
            T: go : a reset T: go : a 1 0 T: go : a reset | 0.25 | 0.75
            """)
    void aRowThatIsResetIsTheStartWhereverThatStands(String text, double a, double b) {
        String start = "start: 0.25 0.75\n";
        for (String whole : List.of(start + BODY + text, BODY + start + text, BODY + text + "\n" + start)) {
            assertArrayEquals(new double[] {a, b}, transitions(parse(HEAD + whole), 0, 0), whole);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"start: b", "start: uniform", "start include: a", "start exclude: a", "# no start"})
    void theOrderOfStartAndResetDoesNotMatter(String start) throws IOException {
        String rows = "T: go : * reset\nT: stay identity\nO: * uniform\nR: stay : b : * : * 1\n";
        assertEquals(written(parse(HEAD + start + "\n" + rows)), written(parse(HEAD + rows + start + "\n")));
    }

    @Test
    void aRowThatIsResetWithoutAStartIsUniform() {
        assertArrayEquals(new double[] {0.5, 0.5}, transitions(parse(HEAD + BODY + "T: go : a reset"), 0, 0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            O: go : b : x 1 O: go : b : y 0 O: go : b : 2 0 | 1 | 0 | 0
            O: go : b 0.5 0.25 0.25 | 0.5 | 0.25 | 0.25
            O: go 1 0 0 0 1 0 | 0 | 1 | 0
            O: * : * 0 0 1 | 0 | 0 | 1
            O: go 1 0 0 0 1 0 O: * : b : * 0 O: * : b : z 1 | 0 | 0 | 1
            """)
    void observationForms(String text, double x, double y, double z) {
        TabularPomdp m = parse(HEAD + BODY + text);
        assertArrayEquals(new double[] {x, y, z}, new double[] {m.observation(0, 1, 0), m.observation(0, 1, 1), m.observation(0, 1, 2)});
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            R: go : a : b : y 7 | 7
            R: * : * : * : * 1 R: go : a : * : y +2.5 | 2.5
            R: * : * : * : * 1 R: go : b : * : * 2 | 1
            R: go : a : b 1 -2 3 | -2
            R: go : a : b : y - 7 | -7
            R: go : a : b + 1 - .5e1 - 3 | -5
            R: go : a 1 2 3 4 5 6 | 5
            R: go : a : b : y 7 R: go : a : * : * 3 | 3
            R: go : a : b : y 7 R: stay : a : * : * 3 | 7
            R: go : a : * : * 3 R: * : * : b : * 4 | 4
            """)
    void rewardForms(String text, double r) {
        assertEquals(r, parse(HEAD + BODY + text).reward(0, 0, 1, 1));
        assertEquals(-r, parse(HEAD.replace("reward", "cost") + BODY + text).reward(0, 0, 1, 1));
    }

    @Test
    void thePreambleMayComeInAnyOrder() {
        TabularPomdp m = parse("observations:2 # two\nactions :1\nstates: 2\nvalues:reward discount:.5 " + BODY);
        assertEquals(List.of("0", "1"), m.states());
        assertEquals(0.5, m.discount());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            nonsense | f:1:1: expected discount, values, states, actions, observations, start, T, O or R, got "nonsense"
            discount 0.9 | f:1:10: expected ":", got "0.9"
            discount: 1.5 | f:1:11: expected a discount in [0, 1], got "1.5"
            values: money | f:1:9: expected reward or cost, got "money"
            states: 0 | f:1:9: expected a number of states from 1 to 1000000, or their names, got "0"
            states: 2 3 | f:1:11: expected discount, values, states, actions, observations, start, T, O or R, got "3"
            states: left 2right | f:1:14: expected the name of a state (a letter, then letters, digits, _ and -), got "2right"
            actions: a.b | f:1:10: expected the name of an action (a letter, then letters, digits, _ and -), got "a.b"
            observations: x é | f:1:17: expected the name of an observation (a letter, then letters, digits, _ and -), got "é"
            states: a b a | f:1:13: expected each name once, got "a" twice
            states: a discount: 0.5 states: b | f:1:25: expected states once, got it on line 1 already
            discount: 0.5 T: x | f:1:18: expected "states:" before T, O and R, got "x"
            states: 30000 actions: 5 observations: 5 discount: 0.9 | f:1:1: expected a model of at most 40000000 numbers, got 4500750000
            """)
    void whatIsWrongWithThePreamble(String text, String message) {
        assertEquals(message, assertThrows(PomdpFileException.class, () -> parse(text)).getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            T: walk identity | f:6:4: expected an action (go, stay), got "walk"
            T: g0 identity | f:6:4: expected an action (go, stay), got "g0"; did you mean go?
            T: go : a : b 1.5 | f:6:15: expected a probability, got "1.5"
            T: go : a : b much | f:6:15: expected a probability, got "much"
            T: go : a 0.5 | f:6:14: expected a probability, 2 in all, got the end of the file
            T: go : a : b - | f:6:15: expected a probability, got "-"
            R: go : a : b : x - - 1 | f:6:19: expected a reward, got "-"
            R: go : a : b : x - -1 | f:6:19: expected a reward, got "-"
            T: go : a 0.5 0.5 0.1 | f:6:19: expected a statement, got "0.1"; the T that began on line 6 takes 2 numbers, this is one too many
            T: go 1 0 0 1 - 1 | f:6:15: expected a statement, got "-1"; the T that began on line 6 takes 4 numbers, this is one too many
            O: go : a : x 0.5 0.5 | f:6:19: expected a statement, got "0.5"; the O that began on line 6 takes 1 number, this is one too many
            O: * uniform 1 | f:6:14: expected a statement, got "1"; the O that began on line 6 takes no number, this is one too many
            R: go : a : b 1 2 3 4 | f:6:21: expected a statement, got "4"; the R that began on line 6 takes 3 numbers, this is one too many
            start: 0.3 0.3 0.4 | f:6:16: expected a statement, got "0.4"; the start that began on line 6 takes 2 numbers, this is one too many
            T: go : 7 : a 1 | f:6:9: expected a state (a, b), got "7"
            O: go : a : * 1e999 | f:6:15: expected a probability, got "1e999"
            T: * identity O: * uniform T: go : b 0.5 0.4 | f:6:28: T: go : b: expected probabilities that sum to 1, got a sum of 0.9
            T: * identity | f:6:14: O: go : a: expected probabilities that sum to 1, got a sum of 0.0
            R: go 1 | f:6:7: expected ":", got "1"
            R: go : a : b : x high | f:6:19: expected a reward, got "high"
            start: a T: * identity O: * uniform stop | f:6:37: expected discount, values, states, actions, observations, start, T, O or R, got "stop"
            start exclude: a b T: * identity | f:6:16: expected at least one state that is not excluded
            start: 0.5 0.4 T: * identity O: * uniform | f:6:1: start: expected probabilities that sum to 1, got a sum of 0.9
            """)
    void whatIsWrongAndWhere(String text, String message) {
        assertEquals(message, assertThrows(PomdpFileException.class, () -> parse(HEAD + text)).getMessage());
    }

    @Property(tries = 2000)
    void anythingIsAModelOrAMessage(@ForAll("statements") List<String> words, @ForAll @IntRange(min = 0, max = 8) int head) {
        String text = (head > 0 ? HEAD : "") + (head > 1 ? BODY : "") + String.join(head % 2 == 0 ? " " : "\n", words);
        try {
            parse(text);
        } catch (PomdpFileException e) {
            assertEquals("f:", e.getMessage().substring(0, 2));
        }
    }

    @Provide
    Arbitrary<List<String>> statements() {
        return Arbitraries.of("T:", "O:", "R:", "T", ":", "*", "a", "b", "go", "stay", "x", "y", "0", "1", "2", "0.5", "-1", "1e9", "1e999",
                "uniform", "identity", "reset", "start:", "start", "include", "exclude:", "states:", "actions: 2", "observations: 3",
                "discount:", "values:", "cost", "-", "+", "# comment", "\u00e9", "NaN", "99999999999").list().ofMaxSize(14);
    }

    @ParameterizedTest
    @ValueSource(strings = {"tiger", "line", "corridor"})
    void theClassicsComeBackAsTheyWere(String name) throws IOException {
        assertRoundTrip(PomdpFiles.read(Path.of("src/test/resources/pomdp", name + ".POMDP")));
    }

    @Property(tries = 200)
    void whatIsWrittenIsReadBack(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) throws IOException {
        assertRoundTrip(random(seed));
    }

    @Property(tries = 300)
    void whatIsWrittenIsForTheLexerOfOtherPrograms(@ForAll("names") Set<String> names) throws IOException {
        List<String> all = List.copyOf(names);
        String[] lines = written(identity(all)).split("\n");
        String states = lines[Arrays.asList(lines).indexOf("values: reward") + 1];
        List<String> words = List.of(states.substring("states: ".length()).split(" "));
        boolean named = words.stream().allMatch(w -> w.matches(LEXER_NAME) && !LEXER_WORDS.contains(w));
        assertTrue(named && words.equals(all) || words.equals(List.of(Integer.toString(all.size()))), states);
        assertEquals(names.stream().allMatch(w -> w.matches(LEXER_NAME) && !LEXER_WORDS.contains(w)), named);
    }

    @Provide
    Arbitrary<Set<String>> names() {
        return Arbitraries.oneOf(Arbitraries.strings().withChars("aZ09_-").ofMinLength(1).ofMaxLength(4),
                Arbitraries.of("s1", "left-1", "Up_2", "k", "q", "m-0")).set().ofMinSize(1).ofMaxSize(3)
                .flatMap(s -> Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.just("")), Tuple.of(1, Arbitraries.of("a.b", "é", "1",
                        "reward", "cost", "T", "start", "identity", "reset"))).map(w -> Stream.concat(s.stream(), Stream.of(w))
                                .filter(n -> !n.isEmpty()).collect(Collectors.toSet())));
    }

    private static TabularPomdp identity(List<String> states) {
        TabularBuilder to = new TabularBuilder(0.5, states, List.of("m"), List.of("u"));
        for (int s = 0; s < states.size(); s++) {
            to.transition(0, s, s, 1);
            to.observation(0, s, 0, 1);
        }
        return to.build();
    }

    private static String written(TabularPomdp m) throws IOException {
        StringWriter out = new StringWriter();
        PomdpFiles.write(m, List.of(), out);
        return out.toString();
    }

    private static TabularPomdp random(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<String> states = random.nextBoolean() ? List.of("p", "q", "r") : List.of("0", "1", "2");
        List<String> seen = random.nextBoolean() ? List.of("start", "T") : List.of("u", "v");
        TabularBuilder to = new TabularBuilder(random.nextDouble(), states, List.of("m", "n"), seen);
        for (int a = 0; a < 2; a++) {
            for (int s = 0; s < 3; s++) {
                double p = random.nextInt(3) == 0 ? 0 : random.nextDouble();
                to.transition(a, s, random.nextInt(2), p);
                to.transition(a, s, 2, 1 - p);
                to.observation(a, s, 0, p / 3);
                to.observation(a, s, 1, 1 - p / 3);
                to.reward(a, s, random.nextInt(-1, 3), random.nextInt(-1, 2), random.nextDouble(-100, 100));
            }
        }
        return to.build();
    }

    private static void assertRoundTrip(TabularPomdp m) throws IOException {
        StringWriter out = new StringWriter();
        PomdpFiles.write(m, List.of("one", "two\nlines"), out);
        TabularPomdp back = parse(out.toString());
        assertEquals(m.discount(), back.discount());
        assertEquals(m.states().size(), back.states().size());
        assertArrayEquals(m.start(), back.start());
        for (int a = 0; a < m.acts().size(); a++) {
            for (int s = 0; s < m.states().size(); s++) {
                assertArrayEquals(transitions(m, a, s), transitions(back, a, s));
                for (int o = 0; o < m.observations().size(); o++) {
                    assertEquals(m.observation(a, s, o), back.observation(a, s, o));
                    for (int k = 0; k < m.states().size(); k++) {
                        assertEquals(m.reward(a, s, k, o), back.reward(a, s, k, o));
                    }
                }
            }
        }
    }

    @Test
    void aFileThatIsNotThereIsNamed() {
        assertThrows(UncheckedIOException.class, () -> PomdpFiles.read(Path.of("no.POMDP")));
    }
}
