package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** MODEL 4.1: a recogniser's n-best list has likelihood sum_k q_k p(l_k | ...). */
class NBestTest {
    private static final double CLOSE = 1e-9;
    private static final Act ASK = Act.of("ASK", "a");
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 4.0), null),
            new TableObject("b", new Vector3(0, 0.6, 0), Map.of("blue", 4.0), null),
            new TableObject("c", new Vector3(0.3, 0.6, 0), Map.of("red", 1.0, "blue", 3.0), null));

    private static HandoverDomain domain(Double... wordCounts) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s ->
                s.speech = new SpeechParameters(0.2, 0.05, 0, 0.3, 0.01, List.of(wordCounts))));
    }

    /** Transcripts and confidences in turn. */
    private static Speech list(HandoverDomain domain, Object... all) {
        List<Speech.Alternative> list = new ArrayList<>();
        for (int k = 0; k < all.length; k += 2) {
            list.add(new Speech.Alternative(Utterance.parse((String) all[k], domain.vocabulary()), (double) all[k + 1]));
        }
        return new Speech(list);
    }

    private static void assertIsBayes(HandoverDomain domain, Object... all) {
        Observation o = new Observation(list(domain, all), null, PickSignal.NONE);
        HandoverBelief start = HandoverBelief.initial(domain);
        assertArrayEquals(BruteForce.normalised(BruteForce.joint(start, ASK, o, 3)),
                start.after(ASK).given(o).probabilities(), CLOSE, () -> "after " + List.of(all));
    }

    @Test
    void alternativesOfOneLength() {
        HandoverDomain domain = domain(0.5, 0.3, 0.2);
        assertIsBayes(domain, "red", 0.7, "blue", 0.3);
        assertIsBayes(domain, "yes red", 0.2, "no blue", 0.5, "red", 0.3);
        assertIsBayes(domain, "red red", 3.0, "blue red", 1.0);
        assertIsBayes(domain, "yes", 0.6, "no", 0.4);
        assertIsBayes(domain, "not red", 0.6, "not blue", 0.4);
    }

    @Test
    void wordsOrNothing() {
        HandoverDomain domain = domain(1.0);
        assertIsBayes(domain, "red", 0.6, "", 0.4);
        assertIsBayes(domain, "red", 0.3, "yes", 0.3, "um", 0.4);
    }

    /** p(l_k) has the factor P(number of words), which cancels between objects but not between alternatives. */
    @Test
    void alternativesOfDifferentLength() {
        HandoverDomain domain = domain(0.5, 0.3, 0.2);
        assertIsBayes(domain, "red", 0.6, "", 0.4);
        assertIsBayes(domain, "red", 0.5, "blue blue blue", 0.5);
    }

    @Test
    void oneReadingIsCertain() {
        HandoverDomain domain = domain(0.5, 0.3, 0.2);
        HandoverBelief asked = HandoverBelief.initial(domain).after(ASK);
        assertArrayEquals(asked.heard(list(domain, "yes red", 1.0)).probabilities(),
                asked.heard(list(domain, "yes red", 5.0, "no blue", 0.0)).probabilities(), 1e-12);
    }

    @Test
    void halfOfTheConfidenceMakesAnAnswer() {
        HandoverDomain domain = domain(1.0);
        HandoverBelief asked = HandoverBelief.initial(domain).after(ASK);
        assertEquals(Answer.YES, asked.heard(list(domain, "yes", 0.6, "no", 0.4)).task().answer());
        assertEquals(Answer.NONE, asked.heard(list(domain, "yes", 0.4, "no", 0.3, "um", 0.3)).task().answer());
        assertEquals(ASK, asked.heard(list(domain, "yes", 0.4, "um", 0.6)).task().openReference(), "still open");
        assertEquals(null, asked.heard(list(domain, "no", 0.6, "um", 0.4)).task().openReference(), "closed");
    }
}
