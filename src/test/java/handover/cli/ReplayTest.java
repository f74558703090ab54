package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A log is believed only if its beliefs follow, bit for bit, from what was done and sensed. */
class ReplayTest {
    @TempDir
    Path folder;
    Path log;

    @BeforeEach
    void simulate() {
        log = folder.resolve("a.jsonl");
        simulate("bowls-and-spoons");
    }

    private void simulate(String domain) {
        assertEquals(Main.FINE, Output.of("simulate", "--domain", domain, "--solver", "confirm", "--solver",
                "random", "--episodes", "10", "--out", log.toString()).code());
    }

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "table-line-6", "table-line-5", "bowls-incremental", "bowls-communicated"})
    void whatWasLoggedAgrees(String domain) {
        simulate(domain);
        Output o = Output.of("replay", log.toString());
        assertEquals("", o.err());
        assertEquals(Main.FINE, o.code());
        assertTrue(o.out().matches("20 episodes with \\d+ steps agree\n"), o.out());
    }

    @Test
    void aLongerRunIsCounted() throws IOException {
        Files.writeString(log, Files.readString(log).replaceFirst("\"episodes\":10,", "\"episodes\":2000000000,"));
        Output o = Output.of("replay", log.toString());
        assertTrue(o.out().matches("20 episodes with \\d+ steps agree; the run was to have 4000000000 episodes\n"), o.out() + o.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"belief", "human_belief"})
    void aChangedDigitIsFound(String which) throws IOException {
        String text = Files.readString(log);
        Matcher m = Pattern.compile("\"" + which + "\":\\[[^\\]]*?0\\.\\d{5}(\\d)\\d*[,\\]]").matcher(text);
        assertTrue(m.find(text.length() / 2));
        char digit = text.charAt(m.start(1)) == '9' ? '8' : '9';
        Files.writeString(log, text.substring(0, m.start(1)) + digit + text.substring(m.end(1)));
        Output o = Output.of("replay", log.toString());
        assertEquals(Main.DIFFERENT, o.code());
        assertTrue(o.err().matches("handover: \\S+a.jsonl: episode \\d of random: step \\d+: " + which
                + " of \\w+: logged [-.0-9E]+, computed [-.0-9E]+\n"), o.err());
        assertEquals("", o.out());
    }

    @Test
    void aTornLastLineIsSkipped() throws IOException {
        String text = Files.readString(log);
        Files.writeString(log, text.substring(0, text.length() - 10));
        Output o = Output.of("replay", log.toString());
        assertEquals("handover: " + log + ": the last line is torn and was skipped\n", o.err());
        assertTrue(o.out().matches("19 episodes with \\d+ steps agree; the run was to have 20 episodes\n"), o.out());
        assertEquals(Main.FINE, o.code());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            "tau":1.0 | "tau":1.1 | line 1: domain: tau: expected a probability in [0, 1], got 1.1
            "tau":1.0 | "tau":0.9 | line 1: domain_hash: expected
            "version":1 | "version":2 | line 1: version: expected a whole number from 1 to 1, got 2
            "format":"handover | "format":"other | line 1: format: expected one of handover-episodes, got "other-episodes"
            "wanted":" | "wannted":" | line 2: wanted: this field is missing
            "act":"ASK" | "act":"ARK" | line 2: steps[0]: ARK(
            "gesture":{"shoulder":[ | "gesture":{"shoulder":["x", | line 2: steps[1].gesture.shoulder: expected [x, y, z], got ["x"
            "belief":[0. | "belief":[1,0. | line 2: steps[2].belief: expected one number for each of the 3 objects
            "measures":{ | "measures":[{ | line 2: column
            """)
    void whatIsNoLogIsSaidWithItsLine(String old, String changed, String message) throws IOException {
        Files.writeString(log, Files.readString(log).replaceFirst(Pattern.quote(old), Matcher.quoteReplacement(changed)));
        Output o = Output.of("replay", log.toString());
        assertTrue(o.err().startsWith("handover: " + log + ": " + message), o.err());
        assertEquals(Main.BAD_INPUT, o.code());
    }
}
