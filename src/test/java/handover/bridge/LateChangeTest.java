package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.Messages;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Simplex;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Replan;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** What changes while a decision is made, at which share of its time, and what is answered then. The test is the clock. */
class LateChangeTest {
    private static final long MS = 1_000_000;
    private static final double LIMIT_MS = 1000;

    private final HandoverDomain domain = DomainFiles.load("table-line-6");
    private final Session session = Session.of(domain, 1, 2);
    private final AtomicLong clock = new AtomicLong();
    /** What happens at which millisecond. */
    private final TreeMap<Long, Runnable> happens = new TreeMap<>();
    private final BlockingQueue<Planner.Plan> plans = new ArrayBlockingQueue<>(100);
    private final List<JsonNode> answers = new ArrayList<>();
    private final Answers client = new Answers() {
        @Override
        public void reply(Client asked, String json) {
            throw new AssertionError(json);
        }

        @Override
        public void decision(Client asked, String json) {
            answers.add(RunningBridge.json(json.getBytes(StandardCharsets.UTF_8)));
        }

        @Override
        public void refuse(Client asked, WireMessage.Envelope envelope, WireException why) {
            throw why;
        }
    };
    private volatile Snapshot newest;
    private int attempts;

    private static byte[] json(String text) {
        return text.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    }

    private void tell(String message) {
        newest = session.apply(Messages.decode(json(message)), clock.get() / 1e9, Session.Journal.NONE).after();
    }

    private void at(long ms, String message) {
        happens.put(ms, () -> tell(message));
    }

    /** A millisecond passes. */
    private void tick() {
        long ms = clock.addAndGet(MS) / MS;
        if (happens.containsKey(ms)) {
            happens.remove(ms).run();
        }
    }

    private static Act likeliest(HandoverBelief belief) {
        double[] b = belief.probabilities();
        return Act.of("ASK", belief.scene().objects().get(Simplex.argmax(b, b.length)).name());
    }

    /** Thinks as long as it may and asks about the likeliest object. */
    private Decision think(HandoverBelief belief, Deadline deadline) {
        attempts++;
        for (int k = 0; k < 10_000 && !deadline.passed(); k++) {
            tick();
        }
        return new Decision(likeliest(belief), Map.of(), 1, 1, false);
    }

    /** The answer to a decision that is asked for now; {@code after} happens when a plan has been made, before it is read. */
    private JsonNode decide(Policy policy, Runnable after) throws InterruptedException {
        try (Planner planner = new Planner(policy, Replan.DEFAULT, () -> newest, clock::get, plans::add)) {
            Decisions decisions = new Decisions(planner, () -> newest, LIMIT_MS, client, new Vitals(0));
            decisions.decide(null, (WireMessage.Decide) Messages.decode(json("{'v':1,'type':'decide','id':'d'}")));
            while (answers.isEmpty()) {
                Planner.Plan plan = plans.poll(30, TimeUnit.SECONDS);
                after.run();
                decisions.planned(plan);
                decisions.tick();
            }
            assertEquals(1, answers.size());
            return answers.get(0);
        }
    }

    private JsonNode decide() throws InterruptedException {
        return decide((belief, deadline, random) -> think(belief, deadline), () -> { });
    }

    private static String summary(JsonNode decision) {
        return decision.get("act").asText() + decision.get("objects") + " for " + decision.get("belief_version").asLong()
                + (decision.get("fallback").asBoolean() ? " fallback" : "");
    }

    private void sureOfTheCylinder() {
        tell("{'v':1,'type':'begin','prior':{'blue_cylinder':0.9,'red_ball':0.1}}");
    }

    private static final String RED = "{'v':1,'type':'speech','text':'red ball, the red sphere'}";

    @Test
    void speechIsHeardUntilATenthOfTheTimeIsLeft() throws InterruptedException {
        for (long ms : new long[] {1, 499, 501, 750, 898}) {
            clock.set(0);
            answers.clear();
            attempts = 0;
            sureOfTheCylinder();
            at(ms, RED);
            assertEquals("ASK[\"red_ball\"] for " + (newest.version() + 1), summary(decide()), "at " + ms);
            assertEquals(2, attempts, "at " + ms);
            assertTrue(clock.get() <= LIMIT_MS * MS);
        }
    }

    @Test
    void laterThePlanForTheEarlierBeliefIsKept() throws InterruptedException {
        sureOfTheCylinder();
        at(960, RED);
        assertEquals("ASK[\"blue_cylinder\"] for 1", summary(decide()));
        assertEquals(1, attempts);
    }

    @Test
    void aBeliefThatNeverRestsStillGetsAPlan() throws InterruptedException {
        sureOfTheCylinder();
        List<Long> starts = new ArrayList<>();
        for (long ms = 1; ms <= 1000; ms++) {
            boolean other = ms % 2 == 1;
            happens.put(ms, () -> newest = newest.with(HandoverBelief.of(newest.belief().task(),
                    new double[] {other ? 0 : 0.75, other ? 0.75 : 0, 0.25, 0, 0, 0}, newest.belief().human())));
        }
        JsonNode decision = decide((belief, deadline, random) -> {
            starts.add(clock.get() / MS);
            return think(belief, deadline);
        }, () -> { });
        assertEquals("ASK", decision.get("act").asText());
        assertEquals(false, decision.get("fallback").asBoolean());
        assertTrue(starts.size() > 10 && starts.size() <= 20, starts.toString());
        assertTrue(starts.get(starts.size() - 1) <= 950, "the last one has time: " + starts);
        assertEquals(995, clock.get() / MS, "and uses it");
    }

    /** A policy that is done at once is not asked again for ever, either. */
    @Test
    void aQuickPolicyIsAskedABoundedNumberOfTimes() throws InterruptedException {
        sureOfTheCylinder();
        decide((belief, deadline, random) -> {
            attempts++;
            double[] b = belief.probabilities();
            newest = newest.with(HandoverBelief.of(newest.belief().task(),
                    new double[] {b[1], b[0], 0, 0, 0, 0}, newest.belief().human()));
            return Decision.of(likeliest(belief));
        }, () -> { });
        assertEquals(20, attempts);
    }

    @Test
    void anotherEpisodeIsPlannedForHoweverLateItBegins() throws InterruptedException {
        for (long ms : new long[] {300, 700, 980}) {
            clock.set(0);
            answers.clear();
            sureOfTheCylinder();
            at(ms, "{'v':1,'type':'begin','prior':{'purple_marker':0.999,'red_ball':0.001}}");
            assertEquals("ASK[\"purple_marker\"] for " + (newest.version() + 1), summary(decide()), "at " + ms);
        }
    }

    @Test
    void aPlanForAnEpisodeOrATableThatIsNoMoreIsNoAnswer() throws InterruptedException {
        String[] changes = {
            "{'v':1,'type':'begin','prior':{'purple_marker':0.999,'red_ball':0.001}}",
            "{'v':1,'type':'scene','removed':['green_marker']}",
            "{'v':1,'type':'acted','act':'POINT','objects':['red_ball'],'status':'started'}"};
        for (String change : changes) {
            clock.set(0);
            answers.clear();
            sureOfTheCylinder();
            JsonNode decision = decide((belief, deadline, random) -> think(belief, deadline), () -> tell(change));
            assertEquals("WAIT[] for " + newest.version() + " fallback", summary(decision), change);
        }
    }

    @Test
    void aPlanThatIsMadeBeforeTheChangeIsMadeAgain() throws InterruptedException {
        sureOfTheCylinder();
        boolean[] begun = {false};
        JsonNode decision = decide((belief, deadline, random) -> Decision.of(likeliest(belief)), () -> {
            if (!begun[0]) {
                begun[0] = true;
                tell("{'v':1,'type':'begin','prior':{'purple_marker':0.999,'red_ball':0.001}}");
            }
        });
        assertEquals("ASK[\"purple_marker\"] for 2", summary(decision));
    }

    /** Trackers jitter: that is no reason to wait, but the robot must reach for where the object is now. */
    @Test
    void whatMovedLastIsReachedForWhereItIsNow() throws InterruptedException {
        sureOfTheCylinder();
        JsonNode decision = decide((belief, deadline, random) -> think(belief, deadline),
                () -> tell("{'v':1,'type':'scene','objects':[{'name':'blue_cylinder','position':[0.1,0.2,0.3]}]}"));
        assertEquals("ASK[\"blue_cylinder\"] for 1", summary(decision));
        assertEquals("[0.1,0.2,0.3]", decision.get("target").toString());
    }

    @Test
    void whatIsSaidLastIsNoReasonToWait() throws InterruptedException {
        sureOfTheCylinder();
        tell("{'v':1,'type':'acted','act':'ASK','objects':['blue_cylinder'],'status':'started'}");
        long asked = newest.version();
        JsonNode decision = decide((belief, deadline, random) -> think(belief, deadline), () -> tell("{'v':1,'type':'speech','text':'yes'}"));
        assertEquals("ASK[\"blue_cylinder\"] for " + asked, summary(decision));
    }

    /** The first plan was broken off; the solver does not return from the second one. */
    @Test
    void aPlanForAnEarlierBeliefIsBetterThanNone() throws InterruptedException {
        sureOfTheCylinder();
        at(500, RED);
        CountDownLatch stuck = new CountDownLatch(1);
        CountDownLatch never = new CountDownLatch(1);
        Policy policy = (belief, deadline, random) -> {
            if (attempts == 0) {
                return think(belief, deadline);
            }
            stuck.countDown();
            try {
                never.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return Decision.of(Act.WAIT);
        };
        try (Planner planner = new Planner(policy, Replan.DEFAULT, () -> newest, clock::get, plans::add)) {
            Decisions decisions = new Decisions(planner, () -> newest, LIMIT_MS, client, new Vitals(0));
            decisions.decide(null, (WireMessage.Decide) Messages.decode(json("{'v':1,'type':'decide','id':'d'}")));
            assertTrue(stuck.await(30, TimeUnit.SECONDS));
            decisions.tick();
            assertEquals(List.of(), answers);
            clock.set(1006 * MS);
            decisions.tick();
            assertEquals("ASK[\"blue_cylinder\"] for 1", summary(answers.get(0)));
        }
    }
}
