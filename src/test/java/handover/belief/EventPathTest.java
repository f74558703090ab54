package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.AnyDomain;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.UnaryOperator;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** MODEL 4.4: what is sensed may come piece by piece, in any order, and gives the posterior of the whole step. */
class EventPathTest {
    private static final double CLOSE = 1e-12;
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0), null),
            new TableObject("b", new Vector3(0.3, 0.6, 0), Map.of("blue", 3.0), null));

    /** An utterance of a whole step is as good as its words and its answer one after the other. */
    @Property(tries = 250, seed = "62", edgeCases = EdgeCasesMode.NONE)
    void eventsInAnyOrderAreTheWholeStep(@ForAll("specs") DomainSpec smoothed, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(smoothed);
        double[] prior = AnyDomain.simplex(domain.start().size(), random);
        HandoverBelief start = HandoverBelief.of(domain.task(domain.start()), prior, prior);
        Act act = AnyDomain.oneOf(domain.start().acts(), random).act();
        int target = act.verb().equals("PICK") ? domain.start().indexOf(act.objects().get(0)) : -1;
        boolean accepted = random.nextBoolean() || target >= 0 && prior[target] == 1;
        HandoverBelief during = target < 0 ? start.after(act) : start.after(act).picked(accepted);
        if (during.scene().size() == 0) {
            return;
        }
        Answer answer = during.task().reference() == null ? Answer.NONE : Answer.values()[random.nextInt(3)];
        List<String> words = random.nextBoolean() ? List.of() : AnyDomain.words(domain, 1 + random.nextInt(3), random);
        Gesture gesture = HumanModel.sampleGesture(during.scene(), random.nextInt(during.scene().size()), random);
        Observation whole = new Observation(Speech.of(new Utterance(answer, words, List.of(), List.of())), gesture,
                target < 0 ? PickSignal.NONE : accepted ? PickSignal.ACCEPTED : PickSignal.REJECTED);
        HandoverBelief expected = start.after(act).given(whole);

        List<UnaryOperator<HandoverBelief>> events = new ArrayList<>();
        events.add(b -> b.saw(gesture));
        words.forEach(w -> events.add(b -> b.heard(Speech.of(w, domain.vocabulary()))));
        if (answer != Answer.NONE) {
            events.add(b -> b.heard(Speech.of(answer.name(), domain.vocabulary())));
        }
        Collections.shuffle(events, random);
        HandoverBelief found = during;
        for (UnaryOperator<HandoverBelief> event : events) {
            found = event.apply(found);
        }
        String step = act + ", " + whole;
        assertArrayEquals(expected.probabilities(), found.closed().probabilities(), CLOSE, step);
        assertArrayEquals(expected.human(), found.human(), 0, step);
        assertEquals(expected.task(), found.task(), step);
        if (!found.task().done()) {
            Act next = AnyDomain.oneOf(found.task().legalActs(), random).act();
            assertArrayEquals(expected.after(next).probabilities(), found.after(next).probabilities(), CLOSE,
                    () -> "the next act closes the step: " + step);
        }
    }

    @Test
    void aStepIsClosedOnce() {
        HandoverBelief closed = asked().closed();
        assertSame(closed, closed.closed());
        assertArrayEquals(closed.after(Act.WAIT).probabilities(), asked().after(Act.WAIT).probabilities(), CLOSE);
        HandoverBelief late = closed.heard(heard("yes"));
        assertEquals(true, late.uninformative(), "after the end of the step");
        assertArrayEquals(closed.probabilities(), late.probabilities(), 0);
    }

    @Test
    void theFirstAnswerClosesTheReference() {
        HandoverBelief yes = asked().heard(heard("yes"));
        assertArrayEquals(new double[] {0.99, 0.01}, yes.probabilities(), CLOSE, "answers err in 1 of 100");
        assertEquals(Answer.YES, yes.task().answer());
        assertEquals(null, yes.task().openReference(), "closed");
        assertEquals(false, yes.uninformative());
        for (String later : List.of("no", "yes", "nope")) {
            HandoverBelief same = yes.heard(heard(later));
            assertArrayEquals(yes.probabilities(), same.probabilities(), 0, () -> "changed by a later " + later);
            assertEquals(yes.task(), same.task(), () -> "changed by a later " + later);
            assertEquals(true, same.uninformative(), later);
        }
        double[] words = yes.heard(heard("blue")).probabilities();
        assertArrayEquals(words, yes.heard(heard("no blue")).probabilities(), CLOSE, "the words of a later answer count");
        assertEquals(true, words[1] > 0.01, "blue is evidence for b");
    }

    @Test
    void anAnswerToNothingIsUninformative() {
        HandoverBelief start = HandoverBelief.initial(asked().domain());
        HandoverBelief yes = start.heard(heard("yes"));
        assertArrayEquals(start.probabilities(), yes.probabilities(), CLOSE);
        assertEquals(true, yes.uninformative());
        assertEquals(Answer.NONE, yes.task().answer());
    }

    @Test
    void contentCountsItsRateOnce() {
        // With surprise 1 and h = (.99, .01), while the robot waits, a speaks at .41 and b at .99.
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s ->
                s.speech = new SpeechParameters(1, 0.05, 0, 1, 0.01, List.of(1.0))));
        HandoverBelief b = HandoverBelief.of(domain.task(domain.start()), new double[] {0.5, 0.5},
                new double[] {0.99, 0.01});
        HandoverBelief heard = b;
        for (String word : List.of("red", "blue", "red", "blue")) {
            heard = heard.heard(Speech.of(word, domain.vocabulary()));
        }
        double rateA = 0.4 + 0.01;
        double rateB = 0.99;
        assertEquals(rateA / (rateA + rateB), heard.closed().probabilities()[0], CLOSE, "the words cancel, the rate stays");
        assertEquals((1 - rateA) / (2 - rateA - rateB), b.closed().probabilities()[0], CLOSE, "silence");
    }

    private static Speech heard(String text) {
        return Speech.of(text, asked().domain().vocabulary());
    }

    private static HandoverBelief asked() {
        return HandoverBelief.initial(new HandoverDomain(DomainSpec.of("x", OBJECTS))).after(Act.of("ASK", "a"));
    }

    /** Domains in which every word can be said of every object. */
    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs().filter(s -> s.speech().alpha() > 0 && s.speech().contrast() < 1);
    }
}
