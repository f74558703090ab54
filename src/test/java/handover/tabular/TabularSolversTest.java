package handover.tabular;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.solver.Deadline;
import handover.solver.Solvers;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What every tabular solver must keep, and how they are named. */
class TabularSolversTest {
    private static final List<TabularPomdp> PROBLEMS = LongStream.range(0, 12).mapToObj(k -> RandomPomdps.of(k, 0.9)).toList();

    static List<String> solvers() {
        return List.of("anytime:most=300,warm=300", "anytime:most=300,warm=0", "point-based:most=300", "exact:H=3", "poss:H=2,C=4", "qmdp",
                "fib", "random");
    }

    @ParameterizedTest
    @MethodSource("solvers")
    void decidesLegallyAlsoWhenTheTimeIsUp(String spec) {
        for (TabularPomdp m : PROBLEMS) {
            TabularPolicy policy = TabularSolvers.parse(spec).solve(m, new SplittableRandom(1));
            for (Deadline deadline : List.of(Deadline.NONE, (Deadline) () -> true)) {
                TabularDecision d = policy.decide(m.start(), deadline, new SplittableRandom(2));
                assertTrue(d.act() >= 0 && d.act() < m.acts().size(), d.toString());
                assertTrue(!(d.lower() > d.upper() + 1e-9), d.toString());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("solvers")
    void theSameSeedGivesTheSameDecisionOnAnyThreadWhateverCameBefore(String spec) {
        for (TabularPomdp m : PROBLEMS) {
            TabularPolicy policy = TabularSolvers.parse(spec).solve(m, new SplittableRandom(1));
            double[] b = m.start();
            TabularDecision alone = policy.decide(b, Deadline.NONE, new SplittableRandom(3));
            double[] corner = new double[b.length];
            corner[0] = 1;
            policy.decide(corner, Deadline.NONE, new SplittableRandom(4));
            IntStream.range(0, 8).parallel().forEach(k -> assertEquals(alone, policy.decide(b, Deadline.NONE, new SplittableRandom(3))));
            TabularPolicy again = TabularSolvers.parse(spec).solve(m, new SplittableRandom(1));
            assertEquals(alone, again.decide(b, Deadline.NONE, new SplittableRandom(3)));
        }
    }

    @Test
    void namesAreReadBack() {
        for (String spec : solvers()) {
            TabularSolver solver = TabularSolvers.parse(spec);
            assertEquals(solver, TabularSolvers.parse(solver.name()));
        }
        TabularSolvers.names().forEach(n -> assertTrue(!TabularSolvers.description(n).isEmpty() && TabularSolvers.parse(n) != null));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            sarsop | expected one of anytime, point-based, exact, poss, qmdp, fib, random
            exact:H=0 | H: expected a whole number from 1 to 100, got "0"
            anytime:gap=-1 | gap: expected the gap between the bounds at which to stop, as a share of the value, at least 0, got "-1"
            point-based:gap=NaN | gap: expected the gap between the bounds at which to stop, as a share of the value, at least 0, got "NaN"
            point-based:gap=Infinity | gap: expected the gap between the bounds at which to stop, as a share of the value, at least 0, got "Infinity"
            anytime:gap=small | gap: expected the gap between the bounds at which to stop, as a share of the value, at least 0, got "small"
            qmdp:H=1 | qmdp has no parameters, got "H=1"
            """)
    void whatCannotBeMeantIsSaid(String spec, String problem) {
        assertEquals("solver \"" + spec + "\": " + problem,
                assertThrows(Solvers.BadSolverException.class, () -> TabularSolvers.parse(spec)).getMessage());
    }

    @Test
    void boundsNeedADiscount() {
        TabularPomdp m = RandomPomdps.of(1, 1);
        assertEquals("this solver needs a discount below 1, got 1.0", assertThrows(IllegalArgumentException.class,
                () -> TabularSolvers.parse("anytime").solve(m, new SplittableRandom(1))).getMessage());
    }
}
