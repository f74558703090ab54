package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.io.DomainFiles;
import handover.math.Streams;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.random.RandomGenerator;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** What comes late counts in the step in which it was sensed, as if it had come in time. */
class TimelineTest {
    private static final HandoverDomain DOMAIN = DomainFiles.domain(DomainFiles.read("bowls-incremental").with(s -> s.tau = 0.9));
    private static final Scene SCENE = DOMAIN.start();
    private static final BeliefTracker START = BeliefTracker.of(HandoverBelief.initial(DOMAIN));
    private static final double MEMORY = 2;

    private record Happened(double t, boolean act, UnaryOperator<BeliefTracker> change) {}

    /** The slow way: everything again from the beginning. */
    private static BeliefTracker fold(List<Happened> all) {
        BeliefTracker t = START;
        for (Happened h : all) {
            t = h.change.apply(t);
        }
        return t;
    }

    @Property(tries = 300)
    void agreesWithComputingEverythingAgain(@ForAll long seed) {
        RandomGenerator random = Streams.of(seed, "timeline", 0);
        List<Happened> all = new ArrayList<>();
        Timeline timeline = Timeline.of(START, 0);
        double now = 0;
        for (int k = 0; k < 60; k++) {
            now += random.nextDouble() * 0.4;
            if (random.nextInt(5) == 0) {
                Act act = SCENE.acts().get(random.nextInt(SCENE.acts().size())).act();
                UnaryOperator<BeliefTracker> change = random.nextInt(3) == 0
                        ? t -> t.act() == null ? t.started(Act.WAIT) : t.abandoned(t.act()) : t -> t.started(act);
                all.add(new Happened(now, true, change));
                timeline = timeline.acted(now, change, MEMORY);
            } else {
                double t = Math.max(0, now - random.nextDouble() * 3);
                UnaryOperator<BeliefTracker> change = sensed(random);
                Timeline before = timeline;
                double arrival = now;
                if (t < now - MEMORY) {
                    assertThrows(Timeline.StaleException.class, () -> before.sensed(t, arrival, change, MEMORY));
                } else {
                    int at = all.size();
                    for (int j = all.size() - 1; j >= 0 && !(all.get(j).act && all.get(j).t <= t); j--) {
                        at = all.get(j).act ? j : at;
                    }
                    all.add(at, new Happened(t, false, change));
                    timeline = timeline.sensed(t, arrival, change, MEMORY);
                }
            }
            assertEquals(fold(all), timeline.now());
        }
    }

    private static UnaryOperator<BeliefTracker> sensed(RandomGenerator random) {
        if (random.nextBoolean()) {
            Speech speech = Speech.of(List.of("yes", "no", "silver", "not the bowl", "the plastic spoon").get(random.nextInt(5)),
                    DOMAIN.vocabulary());
            return t -> t.heard(speech);
        }
        Gesture gesture = new Gesture(DOMAIN.spec().shoulder(), new Vector3(random.nextGaussian(), -3, random.nextGaussian()));
        return t -> t.saw(gesture);
    }

    @Test
    void aLateAnswerIsToTheFirstQuestion() {
        UnaryOperator<BeliefTracker> yes = t -> t.heard(Speech.of("yes", DOMAIN.vocabulary()));
        UnaryOperator<BeliefTracker> first = t -> t.started(Act.of("ASK", "metal_bowl"));
        UnaryOperator<BeliefTracker> second = t -> t.started(Act.of("ASK", "color_bowl"));
        Timeline asked = Timeline.of(START, 0).acted(10, first, MEMORY).acted(12, second, MEMORY);
        HandoverBelief late = asked.sensed(11.9, 12.1, yes, MEMORY).now().now();
        assertEquals(START.started(Act.of("ASK", "metal_bowl")).heard(Speech.of("yes", DOMAIN.vocabulary()))
                .started(Act.of("ASK", "color_bowl")).now(), late);
        assertNotEquals(late, asked.sensed(12, 12.1, yes, MEMORY).now().now());
        assertThrows(Timeline.StaleException.class, () -> asked.sensed(10.0, 12.1, yes, MEMORY));
        assertEquals(asked.now().heard(Speech.of("yes", DOMAIN.vocabulary())), asked.timeless().sensed(11.9, 12.1, yes, MEMORY)
                .now(), "once the clock was set, all that comes is about now");
    }

    /** MODEL 4.4: what is sensed is filtered as it comes, and the first answer of a step closes the reference. */
    @Test
    void withinAStepTheOrderIsThatOfArrival() {
        UnaryOperator<BeliefTracker> yes = t -> t.heard(Speech.of("yes", DOMAIN.vocabulary()));
        UnaryOperator<BeliefTracker> no = t -> t.heard(Speech.of("no", DOMAIN.vocabulary()));
        UnaryOperator<BeliefTracker> ask = t -> t.started(Act.of("ASK", "metal_bowl"));
        UnaryOperator<BeliefTracker> wait = t -> t.started(Act.WAIT);
        Timeline asked = Timeline.of(START).acted(10, ask, MEMORY);
        Timeline inTime = asked.sensed(10.6, 10.7, no, MEMORY).sensed(10.5, 10.9, yes, MEMORY).acted(11, wait, MEMORY);
        Timeline late = asked.acted(11, wait, MEMORY).sensed(10.6, 11.1, no, MEMORY).sensed(10.5, 11.2, yes, MEMORY);
        HandoverBelief denied = wait.apply(no.apply(ask.apply(START))).now();
        assertArrayEquals(denied.probabilities(), inTime.now().now().probabilities(), 1e-12);
        assertEquals(inTime.now(), late.now());
        Timeline other = asked.acted(11, wait, MEMORY).sensed(10.5, 11.1, yes, MEMORY).sensed(10.6, 11.2, no, MEMORY);
        assertNotEquals(late.now(), other.now());
    }

    /** A short episode is remembered to its first event, however long ago that was. */
    @Test
    void aShortEpisodeForgetsNothing() {
        UnaryOperator<BeliefTracker> saw = t -> t.saw(new Gesture(DOMAIN.spec().shoulder(), new Vector3(0.1, -1, -0.3)));
        UnaryOperator<BeliefTracker> ask = t -> t.started(Act.of("ASK", "metal_bowl"));
        UnaryOperator<BeliefTracker> yes = t -> t.heard(Speech.of("yes", DOMAIN.vocabulary()));
        double forever = Double.POSITIVE_INFINITY;
        Timeline timeline = Timeline.of(START).acted(1, ask, forever);
        BeliefTracker expected = ask.apply(START);
        for (int k = 2; k < 2000; k++) {
            expected = k == 100 ? yes.apply(expected) : expected;
            UnaryOperator<BeliefTracker> change = k % 100 == 0 ? t -> t.started(Act.WAIT) : saw;
            timeline = k % 100 == 0 ? timeline.acted(k, change, forever) : timeline.sensed(k, k, change, forever);
            expected = change.apply(expected);
        }
        assertEquals(expected, timeline.sensed(1.5, 3000, yes, forever).now());
    }

    @Test
    void whatWasSensedBeforeTheEpisodeIsStale() {
        Timeline timeline = Timeline.of(START, 100);
        assertThrows(Timeline.StaleException.class, () -> timeline.sensed(99.9, 100.1, t -> t, MEMORY));
        assertEquals(START, timeline.sensed(100, 100.1, t -> t, MEMORY).now());
        Timeline acted = timeline.acted(100.5, t -> t.started(Act.WAIT), MEMORY);
        assertThrows(Timeline.StaleException.class, () -> acted.sensed(99.9, 100.6, t -> t, MEMORY));
        assertEquals(START.started(Act.WAIT), acted.sensed(100, 100.6, t -> t, MEMORY).now());
    }

    /** So many events that they cannot all be remembered: nothing is lost but the possibility to be late. */
    @Test
    void memoryIsBounded() {
        UnaryOperator<BeliefTracker> saw = t -> t.saw(new Gesture(DOMAIN.spec().shoulder(), new Vector3(0.1, -1, -0.3)));
        Timeline timeline = Timeline.of(START, 0).acted(1, t -> t.started(Act.WAIT), MEMORY);
        BeliefTracker expected = START.started(Act.WAIT);
        for (int k = 0; k < 5000; k++) {
            timeline = timeline.sensed(1.1, 1.2, saw, MEMORY);
            expected = saw.apply(expected);
        }
        assertEquals(expected, timeline.now());
        Timeline full = timeline;
        assertThrows(Timeline.StaleException.class, () -> full.sensed(0.9, 1.2, saw, MEMORY));
        Timeline next = full.acted(1.5, t -> t.completed(Act.WAIT, PickSignal.NONE), MEMORY);
        assertEquals(saw.apply(full.now()).completed(Act.WAIT, PickSignal.NONE), next.sensed(1.4, 1.6, saw, MEMORY).now());
        assertThrows(Timeline.StaleException.class, () -> next.sensed(0.9, 1.6, saw, MEMORY), "in a step that is forgotten");
    }

    @Test
    void aChangedTableKeepsWhatIsKnown() {
        HandoverBelief before = START.heard(Speech.of("silver", DOMAIN.vocabulary())).started(Act.of("ASK", "metal_bowl")).now();
        List<TableObject> objects = new ArrayList<>(SCENE.objects());
        TableObject gone = objects.remove(1);
        objects.set(0, objects.get(0).at(new Vector3(0.5, 0.7, 0)));
        objects.add(new TableObject("cup", new Vector3(-0.1, 0.8, 0), java.util.Map.of("cup", 1.0), null));
        HandoverBelief after = before.on(DOMAIN.scene(objects));
        double[] b = before.probabilities();
        double rest = 1 - b[1];
        double[] expected = {0.75 * b[0] / rest, 0.75 * b[2] / rest, 0.75 * b[3] / rest, 0.25};
        for (int i = 0; i < 4; i++) {
            assertEquals(expected[i], after.probabilities()[i], 1e-12);
        }
        assertEquals(0.25, after.human()[3], 1e-12);
        assertEquals(Act.of("ASK", "metal_bowl"), after.task().openReference());
        HandoverBelief yes = after.heard(Speech.of("yes", DOMAIN.vocabulary()));
        assertTrue(yes.probabilities()[0] > after.probabilities()[0], "the question is still open");
        List<TableObject> asked = new ArrayList<>(objects);
        asked.remove(0);
        assertEquals(null, after.on(DOMAIN.scene(asked)).task().openReference(), "not about what is gone");
        assertEquals(before, before.on(SCENE), "nothing changed");
        assertEquals("color_bowl", gone.name());
    }
}
