package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.IncrementalPickDomain;
import handover.domain.PickParameters;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.math.Vector3;
import handover.solver.Confirm;
import handover.solver.Replan;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/**
 * Episodes whose times are worked out by hand. Two objects; the person wants b, says nothing but a true "yes" or "no" to every
 * question, and does not point. A question takes 2.5 s; its one word is heard after 0.3 s.
 */
class TimelineTest {
    private static final double CLOSE = 1e-9;
    private static final DomainSpec ROBOT = DomainSpec.of("two", List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 1.0), "red"),
            new TableObject("b", new Vector3(0.3, 0.6, 0), Map.of("blue", 1.0), "blue")));
    private static final DomainSpec PERSON = ROBOT.with(s -> {
        s.prior = Map.of("a", 0.0, "b", 1.0);
        s.speech = new SpeechParameters(0.2, 0.05, 0, 0, 0, List.of(1.0));
        s.acts.put("ask", new ActParameters(-2.5, 2.5, 0, 0, 1, 1));
        s.acts.put("wait", new ActParameters(-1, 1, 0, 0, 0, 0));
        s.acts.put("pick", new ActParameters(-1, 4, 0, 0, 0, 1));
    });

    private static TimedEpisode play(Agent agent, double latency, double reaction, double patience, int steps) {
        ResponseTimes responses = new ResponseTimes(new Delay.Fixed(reaction), 0.3, 1, 0.2);
        Timing timing = new Timing(new Delay.Fixed(latency), responses, Replan.DEFAULT, patience);
        return new TimedRunner(new HandoverDomain(ROBOT), new HandoverDomain(PERSON), new Confirm(), 1, steps, timing).play(0, agent);
    }

    private static void check(TimedEpisode e, String acts, double[] starts, double[] plannedAt, double end) {
        assertEquals(acts, String.join(" ", e.episode().steps().stream().map(s -> s.act().toString()).toList()));
        assertArrayEquals(starts, all(e, TimedStep::start), CLOSE);
        assertArrayEquals(plannedAt, all(e, TimedStep::plannedAt), CLOSE);
        assertEquals(end, e.times().get(e.times().size() - 1).end(), CLOSE);
        assertEquals(end, e.episode().measures().seconds(), CLOSE);
    }

    private static double[] all(TimedEpisode e, ToDoubleFunction<TimedStep> of) {
        return e.times().stream().mapToDouble(of).toArray();
    }

    /** Asked at 2.0 about a, the person has said "no" at 2.0 + 0.3 + 0.5 + 0.3 = 3.1, and it is sensed at 3.3. */
    @Test
    void sequentialThinksAfterEachAct() {
        TimedEpisode e = play(Agent.SEQUENTIAL, 2, 0.5, 0, 10);
        check(e, "ASK(a) ASK(b) PICK(b)", new double[] {2, 6.5, 11}, new double[] {0, 4.5, 9}, 15);
        assertEquals(3.1, e.times().get(0).arrivals().get(0).at(), CLOSE);
        assertEquals(3.3, e.times().get(0).arrivals().get(0).arrives(), CLOSE);
        assertArrayEquals(new double[] {0, 2, 4}, all(e, TimedStep::plannedFor));
        assertArrayEquals(new double[] {0, 2, 4}, all(e, TimedStep::version));
        assertArrayEquals(new double[] {1, 1, 1}, all(e, TimedStep::plannings));
        assertEquals(0, e.measures().stale());
        assertEquals(6, e.measures().idle(), CLOSE);
        assertEquals(1, e.episode().steps().get(2).belief().task().handovers());
    }

    /** Its plan for silence is dropped at 3.3, when the "no" is sensed, and the one about b at 6.6. */
    @Test
    void concurrentThinksAsSoonAsItHears() {
        TimedEpisode e = play(Agent.CONCURRENT, 2, 0.5, 0, 10);
        check(e, "ASK(a) ASK(b) PICK(b)", new double[] {2, 5.3, 8.6}, new double[] {0, 3.3, 6.6}, 12.6);
        assertArrayEquals(new double[] {0, 2, 4}, all(e, TimedStep::plannedFor));
        assertArrayEquals(new double[] {0, 2, 4}, all(e, TimedStep::version));
        assertArrayEquals(new double[] {1, 2, 2}, all(e, TimedStep::plannings));
        assertEquals(0, e.measures().stale());
        assertEquals(0.8 + 0.8 + 2, e.measures().idle(), CLOSE);
    }

    /** A person who takes 3 s to answer is heard while the robot thinks: it asks the same again and notices only then. */
    @Test
    void sequentialActsOnWhatItKnewBefore() {
        TimedEpisode e = play(Agent.SEQUENTIAL, 2, 3, 0, 3);
        check(e, "ASK(a) ASK(a) ASK(b)", new double[] {2, 6.5, 11}, new double[] {0, 4.5, 9}, 13.5);
        assertEquals(5.8, e.times().get(0).arrivals().get(0).arrives(), CLOSE);
        assertArrayEquals(new double[] {0, 1, 3}, all(e, TimedStep::plannedFor));
        assertArrayEquals(new double[] {0, 2, 4}, all(e, TimedStep::version));
        assertEquals(2, e.measures().stale(), "the second and the third");
        assertEquals(1, e.measures().differing(), "after the second no it would still ask about b");
        // Noticed late, but weighed against the first question: after it a has P(no | a) = .95 * .01 against .95 * .99.
        assertArrayEquals(new double[] {0.01, 0.99}, e.episode().steps().get(0).belief().probabilities(), CLOSE);
    }

    /** The same person interrupts the second question of the concurrent robot, at 5.8, and this is then what "no" is about. */
    @Test
    void concurrentMayBeToldWhileItActs() {
        TimedEpisode e = play(Agent.CONCURRENT, 2, 3, 0, 3);
        check(e, "ASK(a) ASK(a) ASK(b)", new double[] {2, 4.5, 7.8}, new double[] {0, 2, 5.8}, 10.3);
        assertArrayEquals(new double[] {0, 1, 3}, all(e, TimedStep::plannedFor));
        assertArrayEquals(new double[] {0, 1, 3}, all(e, TimedStep::version));
        assertArrayEquals(new double[] {0.5, 0.5}, e.episode().steps().get(0).belief().probabilities(), CLOSE);
        assertArrayEquals(new double[] {0.01, 0.99}, e.episode().steps().get(1).belief().probabilities(), CLOSE);
    }

    /** The question is over at 5.5, the plan for silence is due at 6.0, and "no" comes at 5.8. */
    @Test
    void aPatientRobotThinksAgain() {
        TimedEpisode hasty = play(Agent.CONCURRENT, 3, 2, 0, 2);
        check(hasty, "ASK(a) ASK(a)", new double[] {3, 6}, new double[] {0, 3}, 8.5);
        assertArrayEquals(new double[] {0, 1}, all(hasty, TimedStep::plannedFor));
        assertArrayEquals(new double[] {0, 2}, all(hasty, TimedStep::version));
        assertEquals(1, hasty.measures().differing());
        TimedEpisode patient = play(Agent.CONCURRENT, 3, 2, 0.5, 2);
        check(patient, "ASK(a) ASK(b)", new double[] {3, 8.8}, new double[] {0, 5.8}, 11.3);
        assertEquals(0, patient.measures().stale());
        assertEquals(2, patient.times().get(1).plannings());
    }

    // ---- a "no" to a wrong reach ------------------------------------------------------------------------------------

    /** Reaches for a, of which the robot is sure until it hears "no"; an increment takes 4/3 s. */
    private static TimedEpisode reach(Agent agent, double latency, double reaction) {
        Consumer<DomainSpec.Fields> incremental = s -> {
            s.variant = "incremental";
            s.pick = new PickParameters(3, 1);
        };
        DomainSpec robot = ROBOT.with(incremental).with(s -> s.prior = Map.of("a", 0.9, "b", 0.1));
        Solver solver = new Threshold(0.85);
        Timing timing = new Timing(new Delay.Fixed(latency), new ResponseTimes(new Delay.Fixed(reaction), 0.3, 1, 0.2), Replan.DEFAULT, 0);
        return new TimedRunner(new IncrementalPickDomain(robot), new IncrementalPickDomain(PERSON.with(incremental)), solver, 1, 20,
                timing).play(0, agent);
    }

    private static String acts(TimedEpisode e) {
        return String.join(" ", e.episode().steps().stream().limit(3).map(s -> s.act().toString()).toList());
    }

    /** "No" is out 0.9 s after the reach began and is sensed at 1.1, 0.23 s before the increment is over. */
    @Test
    void aNoInTimeCallsTheReachOff() {
        for (Agent agent : Agent.values()) {
            TimedEpisode e = reach(agent, 0, 0.6);
            assertEquals("PICK(a) PICK(b)", acts(e).substring(0, 15), agent + ": " + acts(e));
            assertEquals(4.0 / 3 - 0.9, e.measures().cancels().get(0).seconds(), CLOSE);
        }
    }

    /**
     * With 1 s of thinking a "no" at 1.5 s after the start of the reach (1.0) falls into the thinking of the sequential robot (2.33 to
     * 3.33), which reaches on; the concurrent one has its plan at 2.33 and starts the second increment before the "no".
     */
    @Test
    void aNoDuringPlanningComesTooLateForTheNextIncrement() {
        TimedEpisode sequential = reach(Agent.SEQUENTIAL, 1, 1.0);
        assertEquals("PICK(a) PICK(a) PICK(b)", acts(sequential));
        assertArrayEquals(new double[] {1, 1 + 4.0 / 3 + 1, 1 + 8.0 / 3 + 2}, Arrays.copyOf(all(sequential, TimedStep::start), 3), CLOSE);
        assertEquals(true, sequential.times().get(1).differs());
        assertEquals(1 + 8.0 / 3 + 2 - 2.3, sequential.measures().cancels().get(0).seconds(), CLOSE);

        TimedEpisode concurrent = reach(Agent.CONCURRENT, 1, 1.0);
        assertEquals("PICK(a) PICK(a) PICK(b)", acts(concurrent));
        assertArrayEquals(new double[] {1, 1 + 4.0 / 3, 1 + 8.0 / 3}, Arrays.copyOf(all(concurrent, TimedStep::start), 3), CLOSE);
        assertEquals(0, concurrent.measures().differing());
        for (TimedEpisode e : List.of(sequential, concurrent)) {
            assertEquals(List.of(2), e.measures().cancels().stream().map(TimedMeasures.Cancel::acts).toList());
        }
    }
}
