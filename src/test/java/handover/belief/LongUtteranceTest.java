package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.GestureParameters;
import handover.domain.HandoverDomain;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** MODEL 4.3: every likelihood is evaluated in a numerically safe way. */
class LongUtteranceTest {
    /** V = {blue, red}: red has odds of 3.2 to 1.2 for a, blue the other way round. */
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0, "blue", 1.0), null),
            new TableObject("b", new Vector3(0.3, 0.6, 0), Map.of("red", 1.0, "blue", 3.0), null));
    private static final HandoverDomain DOMAIN = new HandoverDomain(DomainSpec.of("x", OBJECTS));
    private static final double LOG_ODDS = Math.log(3.2 / 1.2);

    private static Speech say(int reds, int blues) {
        return Speech.of("red ".repeat(reds) + "blue ".repeat(blues), DOMAIN.vocabulary());
    }

    @ParameterizedTest(name = "{0} red, {1} blue")
    @CsvSource({"103, 97", "1003, 997", "3, 0", "997, 1003", "1000, 1000"})
    void logOddsAddUp(int reds, int blues) {
        double[] b = HandoverBelief.initial(DOMAIN).heard(say(reds, blues)).probabilities();
        assertEquals((reds - blues) * LOG_ODDS, Math.log(b[0] / b[1]), 1e-8, "log odds of a to b");
    }

    @ParameterizedTest
    @ValueSource(ints = {200, 2000})
    void anObjectThatAllButVanishedComesBack(int words) {
        HandoverBelief first = HandoverBelief.initial(DOMAIN).heard(say(words, 0));
        assertTrue(first.probabilities()[1] < 1e-80, () -> "b is left with " + first.probabilities()[1]);
        assertTrue(words < 2000 || first.probabilities()[1] == 0, "beyond double precision");
        double[] again = first.heard(say(0, words + 1)).probabilities();
        assertEquals(LOG_ODDS, Math.log(again[1] / again[0]), 1e-6, "one more blue than red");
        double[] nextStep = first.after(Act.WAIT).heard(say(0, words + 1)).probabilities();
        assertEquals(LOG_ODDS, Math.log(nextStep[1] / nextStep[0]), 1e-6, "in the next step");
    }

    @Test
    void aWrongPickLeavesTheRatioOfTheOthers() {
        List<TableObject> three = List.of(OBJECTS.get(0), OBJECTS.get(1),
                new TableObject("c", new Vector3(0, 0.6, 0), Map.of("green", 9.0), null));
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", three));
        // So many greens that a and b are both 0 in double precision, and two more reds for a.
        String text = "green ".repeat(900) + "red red red blue";
        HandoverBelief sure = HandoverBelief.initial(domain).heard(Speech.of(text, domain.vocabulary()));
        assertArrayEquals(new double[] {0, 0, 1}, sure.probabilities(), 0);
        double[] b = sure.after(Act.of("PICK", "c")).picked(false).probabilities();
        assertEquals(2 * LOG_ODDS, Math.log(b[0] / b[1]), 1e-6, "log odds of a to b after c was not it");
        assertEquals(0, b[2], 0, "not c");
    }

    /** With a small variance and eps_g = 0 the density is 0 in double precision for both objects; its ratio is not. */
    @ParameterizedTest
    @ValueSource(doubles = {0.04, 1e-3, 1e-4, 1e-6})
    void gesturesFarFromEverythingStillCompare(double v) {
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s ->
                s.gesture = new GestureParameters(v, 0)));
        Vector3 shoulder = domain.spec().shoulder();
        Gesture up = new Gesture(shoulder, new Vector3(-0.02, 0, 1));
        double nearer = angle(up, OBJECTS.get(0));
        double farther = angle(up, OBJECTS.get(1));
        double logOdds = (farther * farther - nearer * nearer) / (2 * v);
        HandoverBelief seen = HandoverBelief.initial(domain).saw(up);
        assertEquals(false, seen.uninformative(), "the likelihood of no object is 0");
        assertEquals(1 / (1 + Math.exp(-logOdds)), seen.probabilities()[0], 1e-9,
                () -> "log odds " + logOdds + " of a to b, " + seen);
    }

    private static double angle(Gesture g, TableObject o) {
        Vector3 arm = o.position().minus(g.shoulder()).unit();
        return Math.acos(arm.dot(g.direction()));
    }
}
