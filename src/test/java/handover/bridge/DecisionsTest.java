package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.Act;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.domain.HandoverDomain;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.zeromq.SocketType;
import org.zeromq.ZMQ;

/** A robot always gets a legal act in time, whatever the solver does; and it is for the newest belief that there was time for. */
class DecisionsTest {
    private static final Act ASK = Act.of("ASK", "red_ball");

    /** A solver of one policy; {@code ready} calls are spent on warming up. */
    private record Odd(Policy policy) implements Solver {
        @Override
        public String name() {
            return "odd";
        }

        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            return policy;
        }
    }

    /** While a bridge warms up, deadlines are short. */
    private static RunningBridge bridge(Policy policy) {
        return RunningBridge.of("table-line-6", new Odd(policy));
    }

    private static JsonNode decide(RunningBridge bridge, int ms) {
        return bridge.ask("{'v':1,'type':'decide','deadline_ms':" + ms + "}");
    }

    private static void assertFallback(String why, JsonNode decision) {
        assertEquals("WAIT true", decision.get("act").asText() + " " + decision.get("fallback").asBoolean());
        assertTrue(decision.get("note").asText().contains(why), decision.get("note").asText());
    }

    @Test
    void aSolverThatIgnoresItsDeadline() throws InterruptedException {
        CountDownLatch never = new CountDownLatch(1);
        Policy stuck = (belief, deadline, random) -> {
            try {
                never.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(stuck)) {
            bridge.ask("{'v':1,'type':'begin'}");
            for (int k = 0; k < 4; k++) {
                assertFallback("deadline passed", decide(bridge, 20));
            }
            assertFallback("does not return", decide(bridge, 20_000));
            assertEquals("ok", bridge.ask("{'v':1,'type':'speech','text':'red'}").get("type").asText(), "and listens on");
            never.countDown();
            JsonNode later = decide(bridge, 15_000);
            for (int k = 0; k < 1000 && later.get("fallback").asBoolean(); k++) {
                Thread.sleep(10);
                later = decide(bridge, 15_000);
            }
            assertEquals("ASK", later.get("act").asText(), "once they are back, it plans again");
        }
    }

    @Test
    void solversThatFail() {
        Policy[] bad = {
            (b, d, r) -> {
                throw new IllegalStateException("I am lost");
            },
            (b, d, r) -> null,
            (b, d, r) -> Decision.of(Act.of("DANCE")),
            (b, d, r) -> new Decision(Act.WAIT, Map.of(Act.WAIT, Double.NaN), 1, 1, true)};
        String[] why = {"I am lost", "no decision", "DANCE is not possible", "no number"};
        for (int k = 0; k < bad.length; k++) {
            try (RunningBridge bridge = bridge(bad[k])) {
                bridge.ask("{'v':1,'type':'begin'}");
                assertFallback(why[k], decide(bridge, 15_000));
            }
        }
    }

    @Test
    void aSecondQuestionSupersedesTheFirst() {
        CountDownLatch gate = new CountDownLatch(1);
        Policy slow = (belief, deadline, random) -> {
            while (!deadline.passed() && gate.getCount() > 0) {
                Thread.onSpinWait();
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(slow)) {
            bridge.ask("{'v':1,'type':'begin'}");
            ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
            for (String id : new String[] {"a", "b"}) {
                robot.sendMore(new byte[0]);
                robot.send(("{\"v\":1,\"type\":\"decide\",\"id\":\"" + id + "\",\"deadline_ms\":15000}").getBytes(StandardCharsets.UTF_8));
            }
            assertEquals("superseded a", answer(robot));
            gate.countDown();
            assertEquals("decision b", answer(robot));
            bridge.ask("{'v':1,'type':'state'}");
        }
    }

    @Test
    void anEpisodeThatEndsLeavesNoQuestionOpen() {
        Policy slow = (belief, deadline, random) -> {
            while (!deadline.passed()) {
                Thread.onSpinWait();
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(slow)) {
            bridge.ask("{'v':1,'type':'begin'}");
            ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
            robot.sendMore(new byte[0]);
            robot.send("{\"v\":1,\"type\":\"decide\",\"id\":\"a\",\"deadline_ms\":60000}".getBytes(StandardCharsets.UTF_8));
            robot.sendMore(new byte[0]);
            robot.send("{\"v\":1,\"type\":\"end\",\"id\":\"b\"}".getBytes(StandardCharsets.UTF_8));
            assertEquals("summary b", answer(robot));
            assertEquals("error a", answer(robot));
        }
    }

    /** Who lost the answer and asks again must not be told that somebody else asked. */
    @Test
    void theSameQuestionAgainIsNoOtherQuestion() {
        CountDownLatch gate = new CountDownLatch(1);
        AtomicInteger calls = new AtomicInteger();
        Policy slow = (belief, deadline, random) -> {
            calls.incrementAndGet();
            while (!deadline.passed() && gate.getCount() > 0) {
                Thread.onSpinWait();
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(slow)) {
            bridge.ask("{'v':1,'type':'begin'}");
            ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
            int before = calls.get();
            for (int k = 0; k < 2; k++) {
                robot.sendMore(new byte[0]);
                robot.send("{\"v\":1,\"type\":\"decide\",\"id\":\"a\",\"deadline_ms\":15000}".getBytes(StandardCharsets.UTF_8));
            }
            robot.sendMore(new byte[0]);
            robot.send("{\"v\":1,\"type\":\"speech\",\"id\":\"b\",\"text\":\"hello\"}".getBytes(StandardCharsets.UTF_8));
            assertEquals("ok b", answer(robot));
            gate.countDown();
            assertEquals("decision a", answer(robot));
            assertEquals(1, calls.get() - before);
        }
    }

    @Test
    void whoWaitsWhenTheBridgeStopsIsTold() {
        Policy slow = (belief, deadline, random) -> {
            while (!deadline.passed()) {
                Thread.onSpinWait();
            }
            return Decision.of(ASK);
        };
        for (int k = 0; k < 3; k++) {
            try (RunningBridge bridge = bridge(slow)) {
                bridge.ask("{'v':1,'type':'begin'}");
                ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
                robot.sendMore(new byte[0]);
                robot.send("{\"v\":1,\"type\":\"decide\",\"id\":\"a\",\"deadline_ms\":60000}".getBytes(StandardCharsets.UTF_8));
                robot.sendMore(new byte[0]);
                robot.send("{\"v\":1,\"type\":\"state\",\"id\":\"b\"}".getBytes(StandardCharsets.UTF_8));
                assertEquals("state b", answer(robot));
                assertTrue(bridge.stop());
                assertEquals("error a", answer(robot));
            }
        }
    }

    private static String answer(ZMQ.Socket robot) {
        robot.recv();
        JsonNode reply = RunningBridge.json(robot.recv());
        return reply.get("type").asText() + " " + reply.get("re").asText();
    }

    /** The object is taken while the robot thinks; the solver is not asked what to do then. */
    @Test
    void whoWaitsWhenTheTaskIsDoneIsTold() throws InterruptedException {
        CountDownLatch planning = new CountDownLatch(1);
        AtomicInteger done = new AtomicInteger();
        Policy patient = (belief, deadline, random) -> {
            done.addAndGet(belief.task().done() ? 1 : 0);
            if (belief.probabilities()[0] > 0.8) {
                planning.countDown();
                while (!deadline.passed()) {
                    Thread.onSpinWait();
                }
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(patient)) {
            bridge.ask("{'v':1,'type':'begin','prior':{'blue_cylinder':0.9,'red_ball':0.1}}");
            ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
            robot.sendMore(new byte[0]);
            robot.send("{\"v\":1,\"type\":\"decide\",\"id\":\"a\",\"deadline_ms\":60000}".getBytes(StandardCharsets.UTF_8));
            planning.await();
            bridge.ask("{'v':1,'type':'acted','act':'PICK','objects':['blue_cylinder'],'status':'completed','pick':'accepted'}");
            robot.recv();
            JsonNode decision = RunningBridge.json(robot.recv());
            assertEquals("WAIT the episode is over", decision.get("act").asText() + " " + decision.get("note").asText());
            assertFalse(decision.get("fallback").asBoolean());
            assertEquals(0, done.get());
        }
    }

    /** The first plan is for a belief that then moves; the plan that is answered must be for what it moved to. */
    @Test
    void plansAgainWhenTheBeliefMoved() throws InterruptedException {
        CountDownLatch planning = new CountDownLatch(1);
        AtomicInteger attempts = new AtomicInteger();
        Policy patient = (belief, deadline, random) -> {
            if (belief.task().scene().size() < 6) {
                return Decision.of(Act.WAIT);
            }
            if (belief.human()[0] < 0.1 && belief.probabilities()[0] > 0.5) {
                attempts.incrementAndGet();
                planning.countDown();
                while (!deadline.passed()) {
                    Thread.onSpinWait();
                }
            }
            return Decision.of(ASK);
        };
        try (RunningBridge bridge = bridge(patient)) {
            bridge.ask("{'v':1,'type':'begin','prior':{'blue_cylinder':0.9,'red_ball':0.1}}");
            bridge.ask("{'v':1,'type':'acted','act':'POINT','objects':['green_marker'],'status':'started'}");
            ZMQ.Socket robot = bridge.client(SocketType.DEALER, "command");
            robot.sendMore(new byte[0]);
            robot.send("{\"v\":1,\"type\":\"decide\",\"id\":\"a\",\"deadline_ms\":60000}".getBytes(StandardCharsets.UTF_8));
            planning.await();
            bridge.ask("{'v':1,'type':'speech','text':'red ball, the red sphere'}");
            robot.recv();
            JsonNode decision = RunningBridge.json(robot.recv());
            assertEquals(3, decision.get("belief_version").asInt(), "the version after the speech");
            assertTrue(decision.get("belief").get("red_ball").asDouble() > 0.5, decision.toString());
            assertEquals(1, attempts.get());
            assertTrue(decision.get("ms").asDouble() < 50_000, "without waiting for the deadline");
            assertFalse(decision.get("fallback").asBoolean());
        }
    }
}
