package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.io.DomainFiles;
import handover.math.Vector3;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** When reactions come, by hand. */
class ResponseTimesTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("bowls-and-spoons");
    private static final Gesture GESTURE = new Gesture(new Vector3(0, 1, 0), new Vector3(0, -1, 0));
    private static final ResponseTimes TIMES = new ResponseTimes(new Delay.Fixed(0.5), 0.3, 1, 0.2);
    private static final double CLOSE = 1e-12;

    private static ActModel model(Act act) {
        return DOMAIN.start().model(act);
    }

    private static List<Arrival> arrivals(ResponseTimes times, Act act, boolean completes, String said) {
        Speech speech = said == null ? null : Speech.of(said, DOMAIN.vocabulary());
        Observation o = new Observation(speech, GESTURE, PickSignal.NONE);
        return times.arrivals(10, model(act), 4, completes, o, new SplittableRandom(1));
    }

    private static void check(double speech, double gesture, List<Arrival> arrivals) {
        assertEquals(speech, arrivals.get(0).at(), CLOSE);
        assertEquals(speech + 0.2, arrivals.get(0).arrives(), CLOSE);
        assertEquals(gesture, arrivals.get(1).at(), CLOSE);
        assertEquals(gesture + 0.2, arrivals.get(1).arrives(), CLOSE);
        assertEquals(GESTURE, arrivals.get(1).gesture());
        assertEquals(2, arrivals.size());
    }

    @Test
    void peopleLetTheRobotFinishItsQuestion() {
        assertEquals("metal bowl", model(Act.of("ASK", "metal_bowl")).say());
        check(10 + 0.6 + 0.5 + 3 * 0.3, 10 + 0.6 + 0.5, arrivals(TIMES, Act.of("ASK", "metal_bowl"), false, "no silver spoon"));
    }

    @Test
    void aMovementIsSeenFromItsStart() {
        check(10 + 0.5 + 0.3, 10.5, arrivals(TIMES, Act.of("PICK", "metal_bowl"), false, "no"));
        check(10 + 0.5 + 2 * 0.3, 10.5, arrivals(TIMES, Act.of("POINT", "metal_bowl"), false, "plastic bowl"));
    }

    @Test
    void whatBecameOfAPickIsKnownAtItsEnd() {
        check(14 + 0.5 + 0.3, 14.5, arrivals(TIMES, Act.of("PICK", "metal_bowl"), true, "silver"));
    }

    @Test
    void silenceDoesNotArrive() {
        List<Arrival> all = arrivals(TIMES, Act.of("ASK", "metal_bowl"), false, null);
        assertEquals(List.of(GESTURE), all.stream().map(Arrival::gesture).toList());
    }

    /** Uniform over the 4 seconds of the act; of 4,000 draws the mean is 2 to 5 standard errors: false alarm below 1e-6. */
    @Test
    void whileTheRobotWaitsPeopleSpeakAtAnyTime() {
        SplittableRandom random = new SplittableRandom(2);
        Observation o = new Observation(Speech.of("silver spoon", DOMAIN.vocabulary()), null, PickSignal.NONE);
        double sum = 0;
        for (int k = 0; k < 4000; k++) {
            double at = TIMES.arrivals(10, model(Act.WAIT), 4, false, o, random).get(0).at();
            assertTrue(at >= 10 && at < 14, "at " + at);
            sum += at;
        }
        assertEquals(12, sum / 4000, 5 * 4 / Math.sqrt(12 * 4000.0));
    }

    @Test
    void theUntimedSimulatorSensesEverythingAtOnce() {
        Act pick = Act.of("PICK", "metal_bowl");
        for (Act act : List.of(Act.WAIT, Act.of("ASK", "metal_bowl"), pick)) {
            checkAtOnce(10, arrivals(ResponseTimes.NONE, act, false, "no metal bowl"));
        }
        checkAtOnce(14, arrivals(ResponseTimes.NONE, pick, true, "metal bowl"));
    }

    private static void checkAtOnce(double time, List<Arrival> arrivals) {
        assertEquals(2, arrivals.size());
        for (Arrival a : arrivals) {
            assertEquals(time, a.at());
            assertEquals(time, a.arrives());
        }
    }

    /** The same luck whatever is said: agents that know different things meet the same people. */
    @Test
    void timesDoNotDependOnWhatIsSaid() {
        Act act = Act.of("POINT", "metal_bowl");
        double quiet = arrivals(ResponseTimes.DEFAULT, act, false, null).get(0).at();
        List<Arrival> loud = arrivals(ResponseTimes.DEFAULT, act, false, "no");
        assertEquals(quiet, loud.get(1).at());
        assertEquals(0.3, arrivals(ResponseTimes.DEFAULT, act, false, "no silver").get(0).at() - loud.get(0).at(), CLOSE);
    }

    @Test
    void refusesWhatCannotBe() {
        assertThrows(IllegalArgumentException.class, () -> new ResponseTimes(new Delay.Fixed(0), -1, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new ResponseTimes(new Delay.Fixed(0), 0, 2, 0));
        assertThrows(IllegalArgumentException.class, () -> new ResponseTimes(new Delay.Fixed(0), 0, 0, Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new Timing(new Delay.Fixed(0), ResponseTimes.NONE, null, -1));
    }
}
