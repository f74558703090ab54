package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickParameters;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.io.DomainFiles;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** docs/bridge.md, {@code acted}: the belief moves with what the robot did, and an act that nobody could see is undone. */
class BeliefTrackerTest {
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0), null),
            new TableObject("b", new Vector3(0, 0.6, 0), Map.of("blue", 3.0), null),
            new TableObject("c", new Vector3(0.3, 0.6, 0), Map.of("green", 3.0), null));
    private static final HandoverDomain DOMAIN = new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> s.tau = 0.9));
    private static final HandoverBelief START = HandoverBelief.initial(DOMAIN);
    private static final Act ASK = Act.of("ASK", "a");
    private static final Act POINT = Act.of("POINT", "a");
    private static final Act PICK = Act.of("PICK", "a");
    private static final Gesture GESTURE = new Gesture(DOMAIN.spec().shoulder(), new Vector3(0.1, -1, -0.3));

    private static Speech say(String text) {
        return Speech.of(text, DOMAIN.vocabulary());
    }

    private static void assertSameBelief(HandoverBelief expected, HandoverBelief found, String what) {
        assertArrayEquals(expected.probabilities(), found.probabilities(), 1e-12, what);
        assertArrayEquals(expected.human(), found.human(), 1e-12, what);
        assertEquals(expected.task(), found.task(), what);
    }

    @Test
    void startingAnActMovesTheBelief() {
        BeliefTracker t = BeliefTracker.of(START).started(ASK);
        assertSameBelief(START.after(ASK), t.now(), "started");
        assertEquals(ASK, t.act());
        assertSame(START, t.undone());
        BeliefTracker done = t.heard(say("yes")).completed(ASK, PickSignal.NONE);
        assertSameBelief(START.after(ASK).heard(say("yes")), done.now(), "completing a question changes nothing more");
        assertNull(done.act());
        assertEquals(Answer.YES, done.now().task().answer());
    }

    @Test
    void completingWithoutStartingIsBoth() {
        assertSameBelief(BeliefTracker.of(START).started(ASK).completed(ASK, PickSignal.NONE).now(),
                BeliefTracker.of(START).completed(ASK, PickSignal.NONE).now(), "ASK");
        BeliefTracker picked = BeliefTracker.of(START).completed(PICK, PickSignal.REJECTED);
        assertTrue(START.after(PICK).pickPending());
        assertFalse(picked.now().pickPending(), "the outcome is known");
        assertSameBelief(START.after(PICK).picked(false), picked.now(), "PICK");
        assertEquals(0, picked.now().probabilities()[0], 0, "a is not it");
    }

    @Test
    void aPickMustSayHowItEnded() {
        BeliefTracker t = BeliefTracker.of(START).started(PICK);
        assertThrows(IllegalArgumentException.class, () -> t.completed(PICK, PickSignal.NONE));
        assertThrows(IllegalArgumentException.class, () -> t.completed(PICK, PickSignal.MOVING));
        assertEquals(1, t.completed(PICK, PickSignal.ACCEPTED).now().task().handovers());
        assertThrows(IllegalArgumentException.class, () -> t.started(Act.of("PICK", "nothing")));
    }

    @Test
    void anUnfinishedQuestionIsUndone() {
        BeliefTracker t = BeliefTracker.of(START).started(ASK).heard(say("red")).saw(GESTURE).abandoned(ASK);
        assertSameBelief(START.heard(say("red")).saw(GESTURE), t.now(), "what was sensed counts for the step before");
        assertNull(t.now().task().openReference(), "nothing was asked");
        assertNull(t.act());
    }

    @Test
    void aQuestionBeforeTheUndoneOneIsStillOpen() {
        Act second = Act.of("ASK", "b");
        BeliefTracker t = BeliefTracker.of(START).started(ASK).completed(ASK, PickSignal.NONE).started(second);
        BeliefTracker undone = t.heard(say("yes")).abandoned(second);
        assertSameBelief(START.after(ASK).heard(say("yes")), undone.now(), "the yes was to the first question");
    }

    @Test
    void aMovementWasSeen() {
        BeliefTracker point = BeliefTracker.of(START).started(POINT).heard(say("no")).abandoned(POINT);
        assertSameBelief(START.after(POINT).heard(say("no")), point.now(), "what a point told the human stays");
        BeliefTracker pick = BeliefTracker.of(START).started(PICK).abandoned(PICK);
        assertArrayEquals(START.after(PICK).human(), pick.now().human(), 1e-12, "what a reach told the human stays");
        assertNull(pick.now().task().target(), "but the pick is given up");
        assertEquals(false, pick.now().pickPending());
        assertThrows(IllegalStateException.class, () -> pick.now().picked(true));
        assertEquals(3, pick.completed(Act.WAIT, PickSignal.NONE).now().scene().size(), "and it goes on");
    }

    @Test
    void anActThatNeverStartedChangesNothing() {
        BeliefTracker t = BeliefTracker.of(START).started(POINT);
        assertSame(t, t.abandoned(ASK));
        BeliefTracker idle = BeliefTracker.of(START);
        assertSame(idle, idle.abandoned(PICK));
    }

    @Test
    void trackersDoNotChange() {
        BeliefTracker t = BeliefTracker.of(START).started(ASK);
        HandoverBelief before = t.now();
        t.heard(say("no")).saw(GESTURE).completed(ASK, PickSignal.NONE);
        t.abandoned(ASK);
        assertSame(before, t.now());
    }

    /** A "no" that is heard while an increment stalls that would have completed the pick counts, event by event as at once. */
    @Test
    void aNoDuringAStalledLastIncrementCounts() {
        HandoverDomain unsure = DomainFiles.domain(DomainFiles.read("bowls-incremental")
                .with(s -> s.pick = new PickParameters(1, 0.5)));
        Act pick = Act.of("PICK", "metal_bowl");
        Speech no = Speech.of("no", unsure.vocabulary());
        HandoverBelief whole = HandoverBelief.initial(unsure).after(pick).given(new Observation(no, null, PickSignal.NONE));
        HandoverBelief events = BeliefTracker.of(HandoverBelief.initial(unsure)).started(pick).heard(no)
                .completed(pick, PickSignal.NONE).now().closed();
        assertArrayEquals(whole.probabilities(), events.probabilities(), 1e-12);
        assertTrue(events.probabilities()[0] < 0.01, "b = " + events.probabilities()[0]);
    }
}
