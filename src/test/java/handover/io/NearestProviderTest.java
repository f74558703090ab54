package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.solver.Poss;
import handover.solver.Solver;
import handover.solver.Solvers;
import handover.solver.Threshold;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The solver as written on the command line. */
class NearestProviderTest {

    @Test
    void namesAndDefaults() {
        assertEquals(new Nearest(Path.of("a.policy"), 8, 0.1, null), Solvers.parse("nearest:a.policy"));
        assertEquals(new Nearest(Path.of("b/a,b=c.policy"), 1, Double.POSITIVE_INFINITY, null), Solvers.parse("nearest:b/a,b=c.policy,radius=inf,k=1"));
        assertEquals(new Nearest(Path.of("a"), 8, 0.25, new Poss(2, 10, true)), Solvers.parse("nearest:a,radius=0.25,fallback=poss:H=2,C=10"));
        assertEquals(new Nearest(Path.of("a"), 8, 0.1, new Nearest(Path.of("b"), 2, 0.1, new Threshold(0.8))),
                Solvers.parse("nearest:a,fallback=nearest:b,k=2,fallback=threshold:p=0.8"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"nearest:a.policy", "nearest:a,k=3", "nearest:a,k=3,radius=inf,fallback=poss:H=2,C=10", "nearest:a,radius=0.25",
        "nearest:a,radius=0.00001"})
    void aSolverIsFoundUnderItsOwnName(String spec) {
        Solver solver = Solvers.parse(spec);
        assertEquals(spec, solver.name());
        assertEquals(solver, Solvers.parse(solver.name()));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            nearest | expected nearest:FILE[,k=NEIGHBOURS][,radius=DISTANCE][,fallback=SOLVER], in this order
            nearest: | expected nearest:FILE
            nearest:a,k=0 | k: expected a whole number from 1 to 1000, got "0"
            nearest:a,k=many | k: expected a whole number from 1 to 1000, got "many"
            nearest:a,radius=-1 | radius: expected a distance of at least 0, or inf, got "-1"
            nearest:a,radius=NaN | radius: expected a distance of at least 0, or inf, got "NaN"
            nearest:a,fallback=mcts | expected one of poss
            """)
    void whatCannotBeMeantIsSaid(String spec, String problem) {
        String message = assertThrows(Solvers.BadSolverException.class, () -> Solvers.parse(spec)).getMessage();
        assertTrue(message.contains(problem), message);
    }
}
