package handover.contract;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.Act;
import handover.domain.HandoverState;
import handover.domain.Task;
import handover.math.Simplex;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hipparchus.distribution.continuous.ChiSquaredDistribution;

/** Rules about transitions and rewards. */
final class ModelRules {
    private static final double LARGEST_REWARD = 1e7;
    private static final int SAMPLES = 4000;
    /** Of one comparison; a walk makes about 30 of them, so that a sound domain fails once in 300,000 runs. */
    private static final double FALSE_ALARM = 1e-7;

    private ModelRules() {}

    static void sums(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            double sum = 0;
            for (TransitionProb t : walk.model.transitions(v.state(), v.act())) {
                assertTrue(t.p > 0 && t.p <= 1 + 1e-12, "probability " + t.p + " " + v);
                sum += t.p;
            }
            assertEquals(1, sum, 1e-9, "sum of probabilities " + v);
        }
    }

    static void sampler(Walk walk) {
        List<Walk.Visit> visits = walk.visits();
        for (int k = 0; k < visits.size(); k += 1 + visits.size() / 30) {
            Walk.Visit v = visits.get(k);
            Map<State, Double> expected = new HashMap<>();
            walk.model.transitions(v.state(), v.act()).forEach(t -> expected.merge(t.eo.op, t.p, Double::sum));
            Map<State, Integer> counts = new HashMap<>();
            for (int n = 0; n < SAMPLES; n++) {
                counts.merge(walk.model.sample(v.state(), v.act()).op, 1, Integer::sum);
            }
            counts.keySet().forEach(s -> assertTrue(expected.containsKey(s), "drew an impossible " + s + " " + v));
            assertFits(expected, counts, v);
        }
    }

    /** Pearson's chi-square over outcomes expected at least 5 times, the others taken together. */
    private static void assertFits(Map<State, Double> expected, Map<State, Integer> counts, Walk.Visit v) {
        double chi = 0;
        int cells = 0;
        double restExpected = 0;
        double restCount = 0;
        for (Map.Entry<State, Double> e : expected.entrySet()) {
            double mean = e.getValue() * SAMPLES;
            double count = counts.getOrDefault(e.getKey(), 0);
            if (mean >= 5) {
                chi += (count - mean) * (count - mean) / mean;
                cells++;
            } else {
                restExpected += mean;
                restCount += count;
            }
        }
        if (restExpected >= 5) {
            chi += (restCount - restExpected) * (restCount - restExpected) / restExpected;
            cells++;
        }
        if (cells > 1) {
            double p = 1 - new ChiSquaredDistribution(cells - 1).cumulativeProbability(chi);
            assertTrue(p > FALSE_ALARM, "samples do not fit the transitions (chi-square " + chi + " over " + cells + " cells) " + v);
        }
    }

    static void rewards(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            for (TransitionProb t : walk.model.transitions(v.state(), v.act())) {
                assertTrue(Math.abs(t.eo.r) <= LARGEST_REWARD, "reward " + t.eo.r + " " + v);
            }
            HandoverState s = Walk.base(v.state());
            int n = s.human().length;
            double[] h = walk.domain.understood(s.task().effect((Act) v.act()).model(), s.human());
            for (int i = 0; i < n; i++) {
                for (double[] b : new double[][] {Simplex.vertex(n, i), Simplex.uniform(n), h}) {
                    double match = walk.domain.matchReward(b, h, n);
                    assertTrue(Double.isFinite(match) && match <= walk.domain.matchBound(b, n) + 1e-9,
                            "match reward " + match + " above its bound " + walk.domain.matchBound(b, n) + " " + v);
                }
            }
        }
    }

    /** What the human believes is known too, unless they may misperceive acts. */
    static void known(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            HandoverState s = Walk.base(v.state());
            Map<String, Task> tasks = new HashMap<>();
            Map<Task, double[]> humans = new HashMap<>();
            for (int i = 0; i < s.human().length; i++) {
                for (State other : walk.domain.hidden(new HandoverState(i, s.task(), s.human())).keySet()) {
                    for (TransitionProb t : walk.model.transitions(other, v.act())) {
                        HandoverState next = Walk.base(t.eo.op);
                        Task task = next.task();
                        String observed = task.answer() + " " + task.signal();
                        assertEquals(tasks.computeIfAbsent(observed, o -> task), task, "what is known after " + observed + " " + v);
                        if (task.scene().perceivedExactly()) {
                            double[] h = humans.computeIfAbsent(task, k -> next.human());
                            assertArrayEquals(h, next.human(), 1e-12, "h after " + observed + " " + v);
                        }
                    }
                }
            }
        }
    }

    static void terminal(Walk walk) {
        int seen = 0;
        for (Walk.Visit v : walk.visits()) {
            if (walk.model.terminal(v.next())) {
                seen++;
                Action act = walk.legal(v.next()).get(0);
                EnvironmentOutcome o = walk.model.sample(v.next(), act);
                assertEquals(v.next(), o.op, "a terminal state was left, " + v);
                assertEquals(0, o.r, "reward in a terminal state, " + v);
                for (TransitionProb t : walk.model.transitions(v.next(), act)) {
                    assertEquals(v.next(), t.eo.op, "a terminal state can be left, " + v);
                    assertEquals(0, t.eo.r, "reward in a terminal state, " + v);
                }
                assertTrue(Walk.base(v.next()).task().done(), "terminal, but the task is not done, " + v);
            }
        }
        assertTrue(seen > 0, "no random episode ended");
    }
}
