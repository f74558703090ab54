package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.Task;
import handover.io.DomainFiles;
import handover.math.Simplex;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the rules of thumb do at beliefs at which it can be said by hand: four objects, R+ = 50, R- = -150, discount .95. */
class BaselineActsTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("bowls-and-spoons");

    private static HandoverBelief at(Task task, double p, double... h) {
        double rest = (1 - p) / 3;
        return HandoverBelief.of(task, new double[] {rest, rest, p, rest}, h.length == 0 ? Simplex.uniform(4) : h);
    }

    private static Act act(Solver solver, HandoverBelief belief) {
        return solver.solve(belief.domain(), new SplittableRandom(1)).decide(belief, Deadline.NONE, new SplittableRandom(1)).act();
    }

    /** 50 p - 150 (1 - p) > 47.5 from p = 0.9875; p >= 1.5 / 4 from 0.375. */
    @ParameterizedTest
    @CsvSource({"0.25, WAIT", "0.374, WAIT", "0.376, POINT(plastic_spoon)", "0.987, POINT(plastic_spoon)",
        "0.988, PICK(plastic_spoon)", "1, PICK(plastic_spoon)"})
    void theRuleOfThumb(double p, String act) {
        assertEquals(act, act(new Heuristic(), at(DOMAIN.task(DOMAIN.start()), p)).toString());
    }

    /** Uniform: nothing to correct. Sure enough of something else than the human: says so, until it is sure enough to act. */
    @ParameterizedTest
    @CsvSource({"0.25, WAIT", "0.98, ASK(plastic_spoon)", "0.988, PICK(plastic_spoon)"})
    void theGreedyCommunicator(double p, String act) {
        assertEquals(act, act(new Greedy(), at(DOMAIN.task(DOMAIN.start()), p)).toString());
    }

    @Test
    void theGreedyCommunicatorHasNothingToAddWhereItIsUnderstood() {
        double[] asBelieved = {0.02, 0.02, 0.94, 0.02};
        assertEquals(Act.WAIT, act(new Greedy(), at(DOMAIN.task(DOMAIN.start()), 0.9, asBelieved)));
    }

    /** One increment after the other; an objection calls the pick off. */
    @Test
    void anObjectionCallsThePickOff() {
        HandoverDomain domain = DomainFiles.load("bowls-incremental");
        Task reaching = at(domain.task(domain.start()), 0.99).after(Act.of("PICK", "plastic_spoon")).task();
        for (Solver solver : new Solver[] {new Heuristic(), new Greedy(), new Qmdp()}) {
            assertEquals("PICK(plastic_spoon)", act(solver, at(reaching, 0.99)).toString(), solver.name());
        }
        assertEquals("POINT(plastic_spoon)", act(new Heuristic(), at(reaching, 0.6)).toString());
    }

    @Test
    void theFloorFinishesWhatItBegins() {
        HandoverDomain domain = DomainFiles.load("bowls-incremental");
        Task reaching = at(domain.task(domain.start()), 0.99).after(Act.of("PICK", "plastic_spoon")).task();
        for (int seed = 0; seed < 20; seed++) {
            assertEquals("PICK(plastic_spoon)", new RandomActs().solve(domain, new SplittableRandom(1))
                    .decide(at(reaching, 0.1), Deadline.NONE, new SplittableRandom(seed)).act().toString());
        }
    }
}
