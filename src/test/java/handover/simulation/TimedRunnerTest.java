package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.PickParameters;
import handover.domain.Rewards;
import handover.domain.TableObject;
import handover.domain.WrongPick;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import handover.solver.Clairvoyant;
import handover.solver.Confirm;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Poss;
import handover.solver.RandomActs;
import handover.solver.Replan;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The timed simulator is the untimed one plus time, for every solver and variant. */
class TimedRunnerTest {
    private static final int STEPS = 25;
    private static final Delay NOW = new Delay.Fixed(0);

    /** A domain, and people who may be other than it says. */
    record Case(String name, DomainSpec robot, DomainSpec people) {
        HandoverDomain planner() {
            return DomainFiles.domain(robot);
        }

        HandoverDomain human() {
            return people.equals(robot) ? planner() : DomainFiles.domain(people);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Case> cases() {
        DomainSpec bowls = DomainFiles.read("bowls-and-spoons");
        DomainSpec stalling = DomainFiles.read("bowls-incremental").with(s -> {
            s.pick = new PickParameters(2, 0.6);
            s.handovers = 2;
        });
        DomainSpec courses = bowls.with(s -> {
            s.handovers = 3;
            s.tau = 0.9;
            s.wrongPick = WrongPick.REMOVED;
            s.rewards = new Rewards(50, -150, -2, 1, MatchScore.KL, 0.95);
        });
        DomainSpec others = DomainFiles.readHuman(bowls, Path.of("domains/humans/contrary.json")).with(s -> s.objects = s.objects.stream()
                .map(o -> new TableObject(o.name(), o.position(), Map.of("thing", 3.0, "bowl", 1.0), o.label())).toList());
        return Stream.concat(Stream.of("bowls-and-spoons", "table-line-6-incremental", "bowls-incremental-communicated")
                .map(DomainFiles::read).map(d -> new Case(d.name(), d, d)),
                Stream.of(new Case("stalling picks", stalling, stalling), new Case("other courses", courses, courses),
                        new Case("other people with other words", bowls, others)));
    }

    private static List<Solver> solvers() {
        return List.of(new Poss(2, 3, true), new RandomActs(), new Confirm(), new Threshold(0.8), new Clairvoyant());
    }

    private static TimedRunner runner(Case c, Solver solver, PlanningLatency latency, ResponseTimes responses, double patience) {
        return new TimedRunner(c.planner(), c.human(), solver, 7, STEPS, new Timing(latency, responses, Replan.DEFAULT, patience));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void withoutDelaysItIsTheUntimedSimulator(Case c) {
        for (Solver solver : solvers()) {
            EpisodeRunner untimed = new EpisodeRunner(c.planner(), c.human(), solver, 7, STEPS, () -> Deadline.NONE, () -> 0);
            TimedRunner timed = runner(c, solver, NOW, ResponseTimes.NONE, 0);
            for (int k = 0; k < 8; k++) {
                Episode expected = untimed.play(k);
                for (Agent agent : Agent.values()) {
                    TimedEpisode found = timed.play(k, agent);
                    String which = solver.name() + ", " + agent + ", episode " + k;
                    assertEquals(expected.measures(), found.episode().measures(), which);
                    assertEquals(expected.wanted(), found.episode().wanted(), which);
                    checkSteps(expected.steps(), found.episode().steps(), which);
                    assertEquals(0, found.measures().stale(), which);
                    assertEquals(0, found.measures().idle(), 1e-9, which);
                }
            }
        }
    }

    private static void checkSteps(List<Step> expected, List<Step> found, String which) {
        assertEquals(expected.size(), found.size(), which);
        for (int k = 0; k < expected.size(); k++) {
            assertEquals(expected.get(k).act(), found.get(k).act(), which);
            assertEquals(expected.get(k).observation(), found.get(k).observation(), which);
            assertEquals(expected.get(k).reward(), found.get(k).reward(), which);
            assertArrayEquals(expected.get(k).belief().probabilities(), found.get(k).belief().probabilities(), which);
            assertArrayEquals(expected.get(k).belief().human(), found.get(k).belief().human(), which);
        }
    }

    /** People take their time, but thinking takes none: then there is nothing to be gained. */
    @ParameterizedTest
    @MethodSource("cases")
    void withoutLatencyBothAgentsAreTheSame(Case c) {
        for (Solver solver : solvers()) {
            TimedRunner runner = runner(c, solver, NOW, ResponseTimes.DEFAULT, Double.POSITIVE_INFINITY);
            for (int k = 0; k < 8; k++) {
                TimedEpisode sequential = runner.play(k, Agent.SEQUENTIAL);
                TimedEpisode concurrent = runner.play(k, Agent.CONCURRENT);
                String which = solver.name() + ", episode " + k;
                assertEquals(sequential.episode().measures(), concurrent.episode().measures(), which);
                checkSteps(sequential.episode().steps(), concurrent.episode().steps(), which);
                for (int s = 0; s < sequential.times().size(); s++) {
                    assertEquals(sequential.times().get(s).start(), concurrent.times().get(s).start(), which);
                    assertEquals(sequential.times().get(s).arrivals(), concurrent.times().get(s).arrivals(), which);
                }
                assertEquals(0, sequential.measures().stale() + concurrent.measures().stale(), which);
            }
        }
    }

    /** An agent whose acts do not depend on what it believes meets the same people at the same delays, however it thinks. */
    @Test
    void bothAgentsMeetTheSamePeople() {
        Case c = cases().findFirst().orElseThrow();
        TimedRunner runner = runner(c, new RandomActs(), new Delay.LogNormal(1, 0.5), ResponseTimes.DEFAULT, 0);
        for (int k = 0; k < 20; k++) {
            TimedEpisode sequential = runner.play(k, Agent.SEQUENTIAL);
            TimedEpisode concurrent = runner.play(k, Agent.CONCURRENT);
            assertEquals(sequential.episode().measures().discountedReturn(), concurrent.episode().measures().discountedReturn());
            for (int s = 0; s < sequential.times().size(); s++) {
                assertArrayEquals(delays(sequential.times().get(s)), delays(concurrent.times().get(s)), 1e-9);
            }
        }
    }

    private static double[] delays(TimedStep step) {
        return step.arrivals().stream().mapToDouble(a -> a.at() - step.start()).toArray();
    }

    // ---- time --------------------------------------------------------------------------------------------------------

    @Provide
    Arbitrary<PlanningLatency> latencies() {
        return Arbitraries.of(NOW, new Delay.Fixed(0.01), new Delay.Fixed(2), new Delay.LogNormal(1, 1), new PlanningLatency.PerNode(2000));
    }

    @Provide
    Arbitrary<ResponseTimes> responses() {
        return Arbitraries.of(ResponseTimes.NONE, ResponseTimes.DEFAULT, ResponseTimes.DEFAULT.with(new Delay.LogNormal(3, 1)),
                new ResponseTimes(new Delay.Fixed(0.2), 0.1, 1, 4));
    }

    @Provide
    Arbitrary<Double> patiences() {
        return Arbitraries.of(0.0, 0.5, Double.POSITIVE_INFINITY);
    }

    /**
     * Acts follow one another; they start when they are planned and not before; what changed in between is counted; and the same
     * again gives the same.
     */
    @Property(tries = 60)
    void timeRunsForward(@ForAll("latencies") PlanningLatency latency, @ForAll("responses") ResponseTimes responses,
            @ForAll("patiences") double patience, @ForAll @IntRange(min = 0, max = 1000) int index, @ForAll Agent agent,
            @ForAll @IntRange(min = 0, max = 2) int which) {
        Case c = cases().toList().get(which);
        Solver solver = index % 2 == 0 ? new Poss(1, 3, true) : new RandomActs();
        TimedRunner runner = runner(c, solver, latency, responses, patience);
        TimedEpisode e = runner.play(index, agent);
        double before = 0;
        List<Arrival> all = new ArrayList<>();
        for (int k = 0; k < e.times().size(); k++) {
            TimedStep t = e.times().get(k);
            assertTrue(t.start() >= before && t.end() >= t.start(), "act " + k + " of " + e.times());
            assertTrue(t.plannedAt() <= t.start() && t.plannedFor() <= t.version());
            assertTrue(t.plannings() >= 1 && (agent == Agent.CONCURRENT || t.plannings() == 1), "plannings of " + t);
            if (latency instanceof Delay.Fixed fixed) {
                assertTrue(t.start() >= t.plannedAt() + fixed.span());
                if (agent == Agent.SEQUENTIAL) {
                    assertEquals(before, t.plannedAt(), 1e-9);
                    assertEquals(before + fixed.span(), t.start(), 1e-9);
                } else if (patience == 0) {
                    assertTrue(t.start() <= before + fixed.span() + 1e-9, "later than the sequential robot");
                }
            }
            all.forEach(a -> assertTrue(a.arrives() >= a.at()));
            // All that arrived before the planning is in its version, and all since then is not.
            long changes = all.stream().filter(a -> a.arrives() > t.plannedAt() && a.arrives() < t.start()).count();
            assertTrue(t.version() - t.plannedFor() >= changes, "changes since the planning of " + t);
            assertTrue(t.version() - t.plannedFor() <= all.stream().filter(a -> a.arrives() >= t.plannedAt() && a.arrives() <= t.start()).count());
            assertTrue(t.stale() || !t.differs());
            all.addAll(t.arrivals());
            before = t.end();
        }
        assertEquals(before, e.episode().measures().seconds());
        checkReplay(e);
        assertEquals(e.times(), runner.play(index, agent).times());
    }

    /** What was done and sensed, and when, is all that the beliefs follow from. */
    private static void checkReplay(TimedEpisode e) {
        TimedReplay replay = new TimedReplay(e.episode().start());
        for (int k = 0; k < e.times().size(); k++) {
            Step step = e.episode().steps().get(k);
            replay.started(step.act(), step.observation().signal(), e.times().get(k));
            HandoverBelief b = replay.settled(k + 1 < e.times().size() ? e.times().get(k + 1).start() : e.times().get(k).end());
            assertArrayEquals(step.belief().probabilities(), b.probabilities(), "belief after act " + k);
            assertArrayEquals(step.belief().human(), b.human(), "human belief after act " + k);
            assertEquals(step.belief().task(), b.task());
        }
    }

    /** The number of times that a policy is asked again only to see whether it would have differed changes nothing. */
    @Test
    void countsWhatWouldHaveDiffered() {
        Case c = cases().findFirst().orElseThrow();
        Recording recording = new Recording();
        TimedRunner runner = new TimedRunner(c.planner(), c.human(), recording, 3, STEPS,
                new Timing(new Delay.Fixed(2), ResponseTimes.DEFAULT, Replan.DEFAULT, 0));
        long stale = 0;
        long differing = 0;
        for (int k = 0; k < 40; k++) {
            recording.decided.clear();
            TimedEpisode e = runner.play(k, Agent.SEQUENTIAL);
            List<Act> acts = e.episode().steps().stream().map(Step::act).toList();
            // What was asked: one decision for each act, and one more for each that was stale.
            assertEquals(acts.size() + e.measures().stale(), recording.decided.size());
            int asked = 0;
            for (int s = 0; s < acts.size(); s++) {
                assertEquals(acts.get(s), recording.decided.get(asked++));
                if (e.times().get(s).stale()) {
                    assertEquals(e.times().get(s).differs(), !recording.decided.get(asked++).equals(acts.get(s)));
                }
            }
            stale += e.measures().stale();
            differing += e.measures().differing();
        }
        assertTrue(stale > differing && differing > 0, stale + " stale, " + differing + " differing");
    }

    /** What a policy answered, in order. */
    private static final class Recording implements Solver {
        private final List<Act> decided = new ArrayList<>();

        @Override
        public String name() {
            return "recording";
        }

        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            Policy policy = new Poss(1, 5, true).solve(domain, random);
            return (belief, deadline, chance) -> {
                Decision d = policy.decide(belief, deadline, chance);
                decided.add(d.act());
                return d;
            };
        }
    }

    /** With patience for as long as it takes and no tolerance, nothing is ever done on what is known to be out of date. */
    @Test
    void patienceIsNeverStale() {
        Case c = cases().toList().get(1);
        Timing timing = new Timing(new Delay.Fixed(2), ResponseTimes.DEFAULT, new Replan(0), Double.POSITIVE_INFINITY);
        TimedRunner runner = new TimedRunner(c.planner(), c.human(), new Poss(1, 5, true), 7, STEPS, timing);
        int replanned = 0;
        for (int k = 0; k < 30; k++) {
            TimedEpisode e = runner.play(k, Agent.CONCURRENT);
            assertEquals(0, e.measures().differing(), "episode " + k);
            replanned += e.measures().plannings() - e.times().size();
        }
        assertTrue(replanned > 0, "somebody said something in time");
    }

    @Test
    void threadsDoNotMatter() throws InterruptedException {
        Case c = cases().toList().get(1);
        TimedRunner runner = runner(c, new Poss(1, 5, true), new PlanningLatency.PerNode(5000), ResponseTimes.DEFAULT, 0);
        ConcurrentHashMap<Integer, List<TimedStep>> four = new ConcurrentHashMap<>();
        OrderedUnits.until(0, 40, 4, k -> runner.play(k, Agent.CONCURRENT), e -> {
            four.put(e.episode().index(), e.times());
            return false;
        });
        IntStream.range(0, 40).forEach(k -> assertEquals(runner.play(k, Agent.CONCURRENT).times(), four.get(k), "episode " + k));
    }

    @Test
    void whatAPolicyDoesWrongIsSaid() {
        Case c = cases().findFirst().orElseThrow();
        Solver illegal = new Solver() {
            @Override
            public String name() {
                return "illegal";
            }

            @Override
            public Policy solve(HandoverDomain domain, RandomGenerator random) {
                return (belief, deadline, chance) -> Decision.of(Act.of("PICK", "moon"));
            }
        };
        TimedRunner runner = runner(c, illegal, NOW, ResponseTimes.NONE, 0);
        String problem = assertThrows(IllegalStateException.class, () -> runner.play(0, Agent.CONCURRENT)).getMessage();
        assertEquals("illegal chose PICK(moon), which is not legal with [metal_bowl, color_bowl, plastic_spoon, silver_spoon] on the table",
                problem);
    }
}
