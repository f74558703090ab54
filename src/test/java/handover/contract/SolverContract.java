package handover.contract;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/**
 * Everything that a solver must keep. A solver is put under it by three lines:
 *
 * <pre>{@code
 * class AskOnceTest extends SolverContract {
 *     protected Solver solver() { return new AskOnce(); }
 * }
 * }</pre>
 */
public abstract class SolverContract {
    private static final int BELIEFS = 12;

    /** The solver, with parameters that decide within a fraction of a second. */
    protected abstract Solver solver();

    /** The domains that it is tried on, by name or file. */
    protected List<String> domains() {
        return List.of("bowls-and-spoons", "bowls-incremental", "bowls-communicated");
    }

    private interface Check {
        void at(HandoverBelief belief, Policy policy);
    }

    private void everywhere(Check check) {
        for (String name : domains()) {
            HandoverDomain domain = DomainFiles.load(name);
            Policy policy = solver().solve(domain, new SplittableRandom(7));
            beliefs(domain).forEach(belief -> check.at(belief, policy));
        }
    }

    /** Beliefs of random episodes, also certain ones and ones in the middle of a pick. */
    private static List<HandoverBelief> beliefs(HandoverDomain domain) {
        SplittableRandom random = new SplittableRandom(20261122);
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        List<HandoverBelief> all = new ArrayList<>();
        while (all.size() < BELIEFS) {
            int wanted = Simplex.sample(domain.prior(domain.start()), domain.start().size(), random);
            HandoverState state = domain.initialState(domain.start().objects().get(wanted).name());
            HandoverBelief belief = HandoverBelief.initial(domain);
            for (int k = 0; k < 6 && !belief.task().done(); k++) {
                all.add(belief);
                List<ActModel> acts = belief.task().legalActs();
                Act act = acts.get(random.nextInt(acts.size())).act();
                state = (HandoverState) model.sample(state, act).op;
                belief = belief.after(act).given(senses.sample(state, act));
            }
        }
        all.add(HandoverBelief.initial(domain).revealed(0));
        return all;
    }

    private static Decision decide(Policy policy, HandoverBelief belief, Deadline deadline, long seed) {
        return policy.decide(belief, deadline, new SplittableRandom(seed));
    }

    private static void assertLegal(Decision decision, HandoverBelief belief) {
        assertTrue(belief.task().legalActs().stream().anyMatch(m -> m.act().equals(decision.act())),
                decision.act() + " is not legal at " + belief);
    }

    @Test
    void theActIsAlwaysLegal() {
        everywhere((belief, policy) -> assertLegal(decide(policy, belief, Deadline.NONE, 1), belief));
    }

    @Test
    void aDeadlineThatHasPassedStillGetsADecision() {
        everywhere((belief, policy) -> assertLegal(decide(policy, belief, () -> true, 1), belief));
    }

    @Test
    void theSameSeedGivesTheSameDecisionWhateverWasDecidedBefore() {
        everywhere((belief, policy) -> {
            Decision first = decide(policy, belief, Deadline.NONE, 3);
            decide(policy, HandoverBelief.initial(belief.domain()), Deadline.NONE, 4);
            assertEquals(first, decide(policy, belief, Deadline.NONE, 3), "at " + belief);
        });
    }

    @Test
    void valuesAreFiniteAndOfLegalActs() {
        everywhere((belief, policy) -> {
            for (Map.Entry<Act, Double> value : decide(policy, belief, Deadline.NONE, 1).values().entrySet()) {
                assertTrue(Double.isFinite(value.getValue()), value + " at " + belief);
                assertLegal(Decision.of(value.getKey()), belief);
            }
        });
    }

    @Test
    void theBeliefIsLeftAsItWas() {
        everywhere((belief, policy) -> {
            double[] b = belief.probabilities().clone();
            double[] h = belief.human().clone();
            decide(policy, belief, Deadline.NONE, 1);
            assertArrayEquals(b, belief.probabilities());
            assertArrayEquals(h, belief.human());
        });
    }

    @Test
    void aPolicyMayBeSharedByThreads() {
        everywhere((belief, policy) -> {
            Decision alone = decide(policy, belief, Deadline.NONE, 5);
            IntStream.range(0, 8).parallel().mapToObj(k -> decide(policy, belief, Deadline.NONE, 5))
                    .forEach(together -> assertEquals(alone, together, "at " + belief));
        });
    }

    @Test
    void theNameIsWrittenAsOnTheCommandLine() {
        assertTrue(solver().name().matches("[\\w.-]+(:\\S+)?"), solver().name());
    }
}
