package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** MODEL 4.3: what nobody can have said or done leaves the belief as it was, and is reported. */
class UninformativeTest {
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0), null),
            new TableObject("b", new Vector3(0, 0.6, 0), Map.of("blue", 3.0), null),
            new TableObject("c", new Vector3(0.3, 0.6, 0), Map.of("blue", 1.0, "big", 1.0), null));

    private static HandoverDomain domain(double surprise, double answerError) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> {
            s.speech = new SpeechParameters(0, 0.05, 0, surprise, answerError, List.of(0.5, 0.5));
            s.prior = Map.of("a", 0.2, "b", 0.3, "c", 0.5);
        }));
    }

    private static Speech say(HandoverDomain domain, String text) {
        return Speech.of(text, domain.vocabulary());
    }

    @Test
    void wordsThatFitNothing() {
        HandoverDomain domain = domain(0, 0.01);
        HandoverBelief start = HandoverBelief.initial(domain);
        HandoverBelief heard = start.heard(say(domain, "red blue"));
        assertTrue(heard.uninformative(), "nothing is red and blue");
        assertArrayEquals(start.probabilities(), heard.probabilities(), 1e-15);
        Observation o = new Observation(say(domain, "red blue"), null, PickSignal.NONE);
        assertTrue(start.after(Act.WAIT).given(o).uninformative(), "as a whole step");
        assertArrayEquals(start.probabilities(), start.after(Act.WAIT).given(o).probabilities(), 1e-15);
    }

    @Test
    void wordsThatFitOnlyWhatIsExcluded() {
        HandoverDomain domain = domain(0, 0.01);
        HandoverBelief blue = HandoverBelief.initial(domain).heard(say(domain, "blue"));
        assertArrayEquals(new double[] {0, 0.3 / 0.55, 0.25 / 0.55}, blue.probabilities(), 1e-12);
        HandoverBelief red = blue.heard(say(domain, "red"));
        assertTrue(red.uninformative(), "red is excluded already");
        assertArrayEquals(blue.probabilities(), red.probabilities(), 1e-15);
    }

    @Test
    void partsThatExcludeEachOther() {
        HandoverDomain domain = domain(0, 0);
        HandoverBelief asked = HandoverBelief.initial(domain).after(Act.of("ASK", "a"));
        HandoverBelief heard = asked.heard(say(domain, "yes, blue"));
        assertTrue(heard.uninformative(), "who never errs says yes only to a, and a is not blue");
        assertArrayEquals(asked.probabilities(), heard.probabilities(), 1e-15);
    }

    @Test
    void otherPartsStillCount() {
        // Decided in the package: only the part that nobody could have said is left out.
        HandoverDomain domain = domain(0, 0.01);
        HandoverBelief asked = HandoverBelief.initial(domain).after(Act.of("ASK", "a"));
        HandoverBelief heard = asked.heard(say(domain, "yes, red blue"));
        assertTrue(heard.uninformative(), "the words");
        assertArrayEquals(asked.heard(say(domain, "yes")).probabilities(), heard.probabilities(), 1e-12, "the yes");
        Gesture gesture = new Gesture(domain.spec().shoulder(), new Vector3(0, -1, -0.3));
        assertArrayEquals(asked.saw(gesture).probabilities(),
                asked.heard(say(domain, "red blue")).saw(gesture).probabilities(), 1e-12, "the gesture");
    }

    /** To have said something that fits nothing has likelihood 0 for every object too, so its rate is no evidence. */
    @Test
    void theRateOfWordsThatFitNothingIsNoEvidence() {
        HandoverDomain domain = domain(0.3, 0.01);
        HandoverBelief asked = HandoverBelief.initial(domain).after(Act.of("POINT", "a"));
        HandoverBelief heard = asked.heard(say(domain, "red blue"));
        assertTrue(heard.uninformative(), "nothing is red and blue");
        assertArrayEquals(asked.probabilities(), heard.probabilities(), 1e-12,
                () -> "moved from " + asked + " to " + heard);
    }

    @Test
    void unknownWordsAreSilence() {
        HandoverDomain domain = domain(0.3, 0.01);
        HandoverBelief asked = HandoverBelief.initial(domain).after(Act.of("ASK", "a"));
        HandoverBelief um = asked.heard(say(domain, "um, well"));
        assertArrayEquals(asked.probabilities(), um.probabilities(), 1e-15);
        assertEquals(false, um.uninformative(), "possible, only without information");
        assertArrayEquals(asked.closed().probabilities(), um.closed().probabilities(), 1e-12, "and no words came");
    }

    /** People who always answer: rounding must not make the probability of silence negative. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.01, 0.05, 0.1, 0.15, 0.2, 0.3, 0.35, 0.45})
    void silenceOfPeopleWhoAlwaysAnswer(double error) {
        HandoverDomain domain = new HandoverDomain(domain(0, error).spec().with(s -> {
            s.acts.put("ask", new ActParameters(-1, 1, 0.5, 0.3, 1, 1));
            s.acts.put("point", new ActParameters(-1, 1, 0.5, 0.3, 1, 1));
        }));
        HandoverBelief start = HandoverBelief.initial(domain);
        for (String verb : List.of("ASK", "POINT")) {
            HandoverBelief silent = start.after(Act.of(verb, "a")).closed();
            assertTrue(Arrays.stream(silent.probabilities()).allMatch(Double::isFinite), () -> verb + ": " + silent);
            assertArrayEquals(start.probabilities(), silent.probabilities(), 1e-12,
                    () -> "nobody is silent after " + verb + ", so that silence tells nothing");
        }
    }
}
