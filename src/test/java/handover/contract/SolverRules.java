package handover.contract;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;

/** The rules of the solvers' contract, by number. */
public final class SolverRules {
    private static final int THREADS = 4;
    private static final int TIMES = 8;

    private SolverRules() {}

    public static final List<SolverRule> ALL = List.of(
            new SolverRule(1, "the act is always legal", SolverRules::legal),
            new SolverRule(2, "a deadline that has passed, or passes soon, still gets a legal act", SolverRules::deadline),
            new SolverRule(3, "values are finite, and of legal acts", SolverRules::values),
            new SolverRule(4, "the same seed gives the same decision", SolverRules::sameSeed),
            new SolverRule(5, "a decision does not depend on what was decided before", SolverRules::noState),
            new SolverRule(6, "the belief is left as it was", SolverRules::untouched),
            new SolverRule(7, "threads may share a policy", SolverRules::threads),
            new SolverRule(8, "the name is as written on the command line", SolverRules::name));

    private static void assertLegal(Decision decision, HandoverBelief belief) {
        assertNotNull(decision, "no decision at " + belief);
        assertLegal(decision.act(), belief);
    }

    private static void assertLegal(Act act, HandoverBelief belief) {
        assertTrue(belief.task().legalActs().stream().anyMatch(m -> m.act().equals(act)), act + " is not legal at " + belief);
    }

    private static void legal(Trial trial) {
        Policy policy = trial.policy();
        trial.beliefs.forEach(b -> assertLegal(Trial.decide(policy, b, 1), b));
    }

    private static void deadline(Trial trial) {
        Policy policy = trial.policy();
        for (int checks : new int[] {0, 1, 5}) {
            for (HandoverBelief b : trial.beliefs) {
                assertLegal(policy.decide(b, passingAfter(checks), new SplittableRandom(1)), b);
            }
        }
    }

    /** A deadline that passes once it was asked for this many times. */
    private static Deadline passingAfter(int checks) {
        AtomicInteger asked = new AtomicInteger();
        return () -> asked.getAndIncrement() >= checks;
    }

    private static void values(Trial trial) {
        Policy policy = trial.policy();
        for (HandoverBelief b : trial.beliefs) {
            for (Deadline d : List.of(Deadline.NONE, passingAfter(0))) {
                for (Map.Entry<Act, Double> value : policy.decide(b, d, new SplittableRandom(1)).values().entrySet()) {
                    assertTrue(Double.isFinite(value.getValue()), value + " at " + b);
                    assertLegal(value.getKey(), b);
                }
            }
        }
    }

    private static void sameSeed(Trial trial) {
        for (HandoverBelief b : trial.beliefs) {
            assertEquals(Trial.decide(trial.policy(), b, 3), Trial.decide(trial.policy(), b, 3), "at " + b);
        }
    }

    /** Forward, and backward by a policy that has decided other things in between. */
    private static void noState(Trial trial) {
        Policy policy = trial.policy();
        List<Decision> forward = new ArrayList<>();
        trial.beliefs.forEach(b -> forward.add(Trial.decide(policy, b, 3)));
        List<HandoverBelief> backward = new ArrayList<>(trial.beliefs);
        Collections.reverse(backward);
        Collections.reverse(forward);
        for (int k = 0; k < forward.size(); k++) {
            policy.decide(trial.beliefs.get(k), passingAfter(0), new SplittableRandom(4));
            assertEquals(forward.get(k), Trial.decide(policy, backward.get(k), 3), "at " + backward.get(k));
        }
    }

    private static void untouched(Trial trial) {
        Policy policy = trial.policy();
        for (HandoverBelief belief : trial.beliefs) {
            double[] b = belief.probabilities().clone();
            double[] h = belief.human().clone();
            Trial.decide(policy, belief, 1);
            assertArrayEquals(b, belief.probabilities(), "b at " + belief);
            assertArrayEquals(h, belief.human(), "h at " + belief);
        }
    }

    /** Other beliefs at the same time, on the same table and on others. */
    private static void threads(Trial trial) {
        Policy policy = trial.policy();
        List<Decision> alone = trial.beliefs.stream().map(b -> Trial.decide(policy, b, 5)).toList();
        int n = alone.size();
        ExecutorService pool = Executors.newFixedThreadPool(THREADS);
        try {
            List<Future<Decision>> together = IntStream.range(0, TIMES * n)
                    .mapToObj(k -> pool.submit(() -> Trial.decide(policy, trial.beliefs.get(k % n), 5))).toList();
            for (int k = 0; k < together.size(); k++) {
                assertEquals(alone.get(k % n), together.get(k).get(), "at " + trial.beliefs.get(k % n));
            }
        } catch (InterruptedException | ExecutionException e) {
            throw new AssertionError(e);
        } finally {
            pool.shutdownNow();
        }
    }

    /** A solver that is known by name is found again under its own. */
    private static void name(Trial trial) {
        String name = trial.solver.name();
        assertTrue(name.matches("[\\w.-]+(:\\S+)?"), name);
        if (Solvers.names().contains(name.split(":")[0])) {
            assertEquals(trial.solver, Solvers.parse(name));
        }
    }
}
