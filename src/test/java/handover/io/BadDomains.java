package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.math.Vector3;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;

/** Domain files with one thing wrong, and what the reader says of it. */
final class BadDomains {
    static final String CUP = "{'name': 'cup', 'position': [0, 0.6, 0], 'words': {'red': 1, 'cup': 2}}";
    static final String BOX = "{'name': 'box', 'position': [0.3, 0.6, 0], 'words': {'red': 1, 'box': 2}}";
    static final String GOOD = "{'name': 'x', 'objects': [" + CUP + ", " + BOX + "]}";

    private static final String TOP = "; this is a domain file, which may have here name, description, variant, objects, prior, "
            + "pointing_origin, shoulder, tau, tau_human, handovers, wrong_pick, ask, understanding, perception, speech, gesture, "
            + "rewards, pick, communicated, acts, frames, adapters";

    /**
     * One bad file.
     *
     * @param text of the file
     * @param message what the reader says after the file's name
     * @param seenBySchema whether the schema refuses it too; it cannot see what is not JSON or how fields go together
     */
    record Bad(String text, String message, boolean seenBySchema) {
        @Override
        public String toString() {
            return message;
        }
    }

    private BadDomains() {}

    static Stream<Bad> all() {
        return Stream.of(notJson(), numbers(), kinds(), keys(), ranges(), together()).flatMap(List::stream);
    }

    private static List<Bad> notJson() {
        return List.of(
                hidden("", "expected a JSON value, got nothing"),
                hidden("{'name': 'x',\n 'objects': [{'name': 'cup', 'posi",
                        "line 2, column 35: the file ends here, but not everything that was opened is closed"),
                hidden("{'name': 'x',\n 'objects': [{'name': 'cup'",
                        "line 2, column 28: the file ends here, but not everything that was opened is closed"),
                hidden("{'name': 'x',\n 'objects': [],\n}", "line 3, column 1: expected a key in double quotes, got }"),
                hidden("{name: 'x'}", "line 1, column 2: expected a key in double quotes, got name: \"x\"}"),
                hidden("{'name' 'x'}", "line 1, column 9: expected a colon between key and value, got \"x\"}"),
                hidden("{'name': 'x'\n'objects': []}",
                        "line 2, column 1: expected a comma or a closing bracket, got \"objects\": []}"),
                hidden("{'objects': [1}", "line 1, column 15: expected a closing bracket of the other kind, got }"),
                hidden("{'tau': yes}", "line 1, column 9: expected a value: a number, text in double quotes, [...] or {...},"
                        + " got yes}"),
                hidden("{'objects': [1,]}", "line 1, column 16: expected a value: a number, text in double quotes, [...] or"
                        + " {...}, got ]}"),
                hidden("{'tau': 01}", "line 1, column 10: expected a number such as 0.5 or -2e3, got 1}"),
                hidden("{'name': 'two\nlines'}", "line 1, column 14: expected text in double quotes on one line,"
                        + " got the end of the line"),
                hidden("{'name': '\\q'}", "line 1, column 12: expected a character that may follow a backslash, got q\"}"),
                hidden("// a table\n{}", "line 1, column 1: expected JSON, which has no comments, got // a table"),
                hidden(GOOD + "\n{}", "line 2, column 1: expected the end of the file, got {}"),
                hidden("{'name': 'x'}}", "line 1, column 14: expected the end of the file, got }"),
                hidden("[".repeat(100_000), "line 1, column 52: nested more than 50 levels deep"),
                hidden("{'tau': " + "1".repeat(2000) + "}", "line 1, column 2009: a number or a key that is too long"),
                hidden("{'name': 'x', 'speech': {'alpha': 1, 'alpha': 2}}",
                        "speech.alpha: the key is there twice, again in line 1, column 47"),
                hidden("{'objects': [" + CUP + ", {'name': 'a', 'name': 'b'}]}",
                        "objects[1].name: the key is there twice, again in line 1, column 109"));
    }

    private static List<Bad> numbers() {
        return List.of(
                hidden(with("'tau': NaN"), "tau: expected a finite number, got NaN"),
                hidden(with("'shoulder': [0, -Infinity, 0]"), "shoulder[1]: expected a finite number, got -Infinity"),
                hidden(with("'rewards': {'right': 1e999}"), "rewards.right: expected a finite number, got 1e999"),
                seen(with("'tau': 1" + "0".repeat(400)), "tau: expected a number, got 1" + "0".repeat(59) + "..."),
                seen(with("'handovers': 1.5"), "handovers: expected a whole number, got 1.5"),
                seen(with("'handovers': 99999999999"), "handovers: expected a whole number, got 99999999999"));
    }

    private static List<Bad> kinds() {
        return List.of(
                seen("[]", "expected an object {...}, got []"),
                seen("{'name': 'x', 'objects': {}}", "objects: expected a list [...], got {}"),
                seen("{'name': 'x', 'objects': ['cup']}", "objects[0]: expected an object {...}, got \"cup\""),
                seen("{'name': 5, 'objects': [" + CUP + "]}", "name: expected text in double quotes, got 5"),
                seen("{'name': null, 'objects': [" + CUP + "]}", "name: expected text in double quotes, got null"),
                seen(with("'tau': '1'"), "tau: expected a number, got \"1\""),
                seen(with("'tau': null"), "tau: expected a number, got null"),
                seen(with("'tau': true"), "tau: expected a number, got true"),
                seen(with("'handovers': '2'"), "handovers: expected a whole number, got \"2\""),
                seen(with("'speech': []"), "speech: expected an object {...}, got []"),
                seen(with("'speech': {'word_counts': 1}"), "speech.word_counts: expected a list [...], got 1"),
                seen(with("'speech': {'word_counts': [1, null]}"), "speech.word_counts[1]: expected a number, got null"),
                seen(with("'prior': {'cup': '1'}"), "prior.cup: expected a number, got \"1\""),
                seen(with("'acts': {'ask': -2}"), "acts.ask: expected an object {...}, got -2"),
                seen(with("'wrong_pick': 'back'"), "wrong_pick: expected one of returned, removed, terminal, got \"back\""),
                seen(with("'ask': {'sets': 'Singletons'}"),
                        "ask.sets: expected one of singletons, attributes, got \"Singletons\""),
                seen(with("'rewards': {'match_score': 1}"), "rewards.match_score: expected one of brier, log, linear, kl, "
                        + "l1, l2, js, none, got 1"),
                seen(object("'position': ['left', 0.6, 0], 'words': {}"),
                        "objects[0].position[0]: expected metres, got \"left\""),
                seen(object("'position': [0, 0.6], 'words': {}"),
                        "objects[0].position: expected [x, y, z] in metres, got [0,0.6]"),
                seen(object("'position': [0, 0.6, 0, 1], 'words': {}"),
                        "objects[0].position: expected [x, y, z] in metres, got [0,0.6,0,1]"),
                seen(object("'position': {'x': 0}, 'words': {}"),
                        "objects[0].position: expected [x, y, z] in metres, got {\"x\":0}"),
                seen(object("'position': [0, 0.6, 0], 'words': ['red']"),
                        "objects[0].words: expected an object {...}, got [\"red\"]"),
                seen(object("'position': [0, 0.6, 0], 'words': {'red': 'often'}"),
                        "objects[0].words.red: expected a number, got \"often\""),
                seen(object("'position': [0, 0.6, 0], 'words': {}, 'label': 7"),
                        "objects[0].label: expected text in double quotes, got 7"));
    }

    private static List<Bad> keys() {
        return List.of(
                seen("{'objects': [" + CUP + "]}", "name: this key is missing"),
                seen("{'name': 'x'}", "objects: this key is missing"),
                seen(object("'position': [0, 0.6, 0]"), "objects[0].words: this key is missing"),
                seen(with("'frames': {'table': {}}"),
                        "frames.table: expected another name, because this is the frame that the domain is in"),
                seen(with("'frames': {'cam': {'rotaton': []}}"), "frames.cam.rotaton: unknown key (did you mean "
                        + "\"rotation\"?); this is a domain file, which may have here rotation, translation"),
                seen(with("'frames': {'cam': {'matrix': [[1, 0, 0, 0]]}}"),
                        "frames.cam.matrix: expected 4 rows of 4 numbers, got [[1,0,0,0]]"),
                hidden(with("'frames': {'cam': {'matrix': [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]}}"),
                        "frames.cam.matrix[3]: expected [0, 0, 0, 1], got [0,0,1,1]"),
                seen(with("'frames': {'cam': {'rotation': [1, 0, 0]}}"),
                        "frames.cam.rotation[0]: expected a list [...], got 1"),
                seen(with("'adapters': {'mic': {}}"), "adapters.mic.type: this key is missing"),
                seen(with("'adapters': {'mic': {'type': 'sound'}}"),
                        "adapters.mic.type: expected one of speech, gesture, got \"sound\""),
                seen(with("'tua': 1"), "tua: unknown key (did you mean \"tau\"?)" + TOP),
                seen(with("'transparency': 1"), "transparency: unknown key" + TOP),
                seen(with("'speech': {'aplha': 1}"), "speech.aplha: unknown key (did you mean \"alpha\"?); this is a domain "
                        + "file, which may have here alpha, negation_factor, contrast, surprise, answer_error, word_counts"),
                seen(object("'positon': [0, 0.6, 0], 'words': {}"), "objects[0].positon: unknown key (did you mean "
                        + "\"position\"?); this is a domain file, which may have here name, position, words, label"),
                seen(with("'acts': {'piont': {'reward': -2}}"), "acts.piont: unknown act (did you mean \"point\"?); a new act "
                        + "must also give duration, speech_rate, gesture_rate, answer_if_match, answer_if_miss"),
                seen(with("'acts': {'juggle': {}}"), "acts.juggle: unknown act; a new act "
                        + "must also give reward, duration, speech_rate, gesture_rate, answer_if_match, answer_if_miss"),
                seen(with("'acts': {'ASK': {'reward': -2}}"),
                        "acts.ASK: expected the name of a type of act in lower case, got \"ASK\""));
    }

    private static List<Bad> ranges() {
        return List.of(
                hidden(with("'frames': {'cam': {'rotation': [0, 0, 0, 1.1]}}"), "frames.cam.rotation: expected a quaternion "
                        + "[x, y, z, w] of length 1, got [0,0,0,1.1]"),
                hidden(with("'frames': {'cam': {'rotation': [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}}"),
                        "frames.cam.rotation: expected a rotation, got one that mirrors"),
                hidden(with("'frames': {'cam': {'rotation': [[1, 0, 0], [0, 2, 0], [0, 0, 1]]}}"), "frames.cam.rotation: expected "
                        + "rows of length 1 at right angles, got a product of 4.0 of rows 1 and 1"),
                seen(with("'frames': {'cam': {'translation': [0, 0, 1000]}}"),
                        "frames.cam.translation[2]: expected metres in [-100, 100], got 1000.0"),
                seen("{'name': 'x', 'objects': []}", "objects: expected at least 1 object, got none"),
                seen(with("'tau': 1.5"), "tau: expected a probability in [0, 1], got 1.5"),
                seen(with("'speech': {'answer_error': -0.1}"),
                        "speech.answer_error: expected a probability in [0, 1], got -0.1"),
                seen(with("'acts': {'ask': {'answer_if_miss': 2}}"),
                        "acts.ask.answer_if_miss: expected a probability in [0, 1], got 2.0"),
                seen(with("'rewards': {'discount': 1}"), "rewards.discount: expected a discount in [0, 1), got 1.0"),
                seen(with("'rewards': {'right': 1e300}"),
                        "rewards.right: expected a reward in [-1000000, 1000000], got 1.0E300"),
                seen(with("'handovers': 0"), "handovers: expected a count in [1, 1000], got 0.0"),
                seen(with("'gesture': {'variance': 0}"),
                        "gesture.variance: expected a variance in rad^2 in [1.0E-6, 1000], got 0.0"),
                seen(with("'speech': {'word_counts': [0.5, 2]}"),
                        "speech.word_counts[1]: expected a probability in [0, 1], got 2.0"),
                seen(with("'pointing_origin': [0, 0, 101]"),
                        "pointing_origin[2]: expected metres in [-100, 100], got 101.0"),
                seen(object("'position': [0, 1e6, 0], 'words': {}"),
                        "objects[0].position[1]: expected metres in [-100, 100], got 1000000.0"),
                seen(object("'position': [0, 0.6, 0], 'words': {'red': -1}"),
                        "objects[0].words.red: expected a count in [0, 1.0E9], got -1.0"),
                seen(object("'position': [0, 0.6, 0], 'words': {'Red': 1}"),
                        "objects[0].words.Red: expected one lower-case word, got \"Red\""),
                seen(object("'position': [0, 0.6, 0], 'words': {'light red': 1}"),
                        "objects[0].words.light red: expected one lower-case word, got \"light red\""),
                seen(object("'position': [0, 0.6, 0], 'words': {'wrong': 1}"), "objects[0].words.wrong: expected a word that "
                        + "describes the object; this one is heard as an answer, as \"not\" or as \"but\", got \"wrong\""),
                seen("{'name': 'x', 'objects': [{'name': 'red cup', 'position': [0, 0.6, 0], 'words': {}}]}",
                        "objects[0].name: expected letters, digits, '_', '-' or '.', got \"red cup\""));
    }

    private static List<Bad> together() {
        return List.of(
                hidden("{'name': 'x', 'objects': [" + BOX + ", " + CUP + ", " + BOX + "]}",
                        "objects[2].name: expected a name that no other object has, got \"box\""),
                hidden(object("'position': [0.15, 1.4, 0.351], 'words': {}"), "objects[0].position: expected at least 0.01 m "
                        + "from the human's shoulder, or there is no direction to it, got " + new Vector3(0.15, 1.4, 0.351)),
                hidden(object("'position': [0, 0, 0.3], 'words': {}"), "objects[0].position: expected at least 0.01 m "
                        + "from the robot's pointing_origin, or there is no direction to it, got " + new Vector3(0, 0, 0.3)),
                hidden(with("'speech': {'alpha': 0}").replace("{'red': 1, 'box': 2}", "{'red': 0}"),
                        "objects[1].words: expected at least one word with a count above 0, because with speech.alpha = 0 "
                        + "nothing that is said could mean this object"),
                hidden(with("'prior': {'cup': 0.5, 'box': 0.4}"),
                        "prior: expected probabilities that sum to 1, got 0.9"),
                hidden(with("'prior': {'cup': 0.5, 'mug': 0.5}"),
                        "prior.mug: expected the name of an object, one of [cup, box], got \"mug\""),
                hidden(with("'speech': {'word_counts': [0.5, 0.4]}"), "speech.word_counts: expected probabilities of 1, 2, ... "
                        + "words that sum to 1, got [0.5, 0.4]"),
                seen(with("'speech': {'word_counts': []}"), "speech.word_counts: expected probabilities of 1, 2, ... "
                        + "words that sum to 1, got []"));
    }

    /** A good file with one more key. */
    static String with(String entry) {
        return GOOD.substring(0, GOOD.length() - 1) + ", " + entry + "}";
    }

    private static String object(String entries) {
        return "{'name': 'x', 'objects': [{'name': 'cup', " + entries + "}]}";
    }

    private static Bad seen(String text, String message) {
        return new Bad(quoted(text), message, true);
    }

    private static Bad hidden(String text, String message) {
        return new Bad(quoted(text), message, false);
    }

    /** The tree of a text with single quotes. */
    static JsonNode json(String text) {
        return JsonText.parse(quoted(text).getBytes(StandardCharsets.UTF_8), "x");
    }

    /** Java strings with JSON are easier to read with single quotes. */
    static String quoted(String json) {
        return json.replace('\'', '"');
    }
}
