package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import handover.solver.BurlapSparseSampling;
import handover.solver.Clairvoyant;
import handover.solver.Confirm;
import handover.solver.Greedy;
import handover.solver.Heuristic;
import handover.solver.Poss;
import handover.solver.Qmdp;
import handover.solver.RandomActs;
import handover.solver.Solver;
import handover.solver.Solvers;
import handover.solver.Threshold;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Solvers by name, as written on the command line. */
class SolversTest {

    @Test
    void namesAndDefaults() {
        assertEquals(new Poss(3, 10, true), Solvers.parse("poss"));
        assertEquals(new Poss(2, 10, true), Solvers.parse("poss:H=2"));
        assertEquals(new Poss(1, 4, false), Solvers.parse("poss:C=4,leaf=zero,H=1"));
        assertEquals(new Threshold(0.9), Solvers.parse("threshold"));
        assertEquals(new Threshold(0.75), Solvers.parse("threshold:p=0.75"));
        assertEquals(new Confirm(), Solvers.parse("confirm"));
        assertEquals(new RandomActs(), Solvers.parse("random"));
        assertEquals(new Clairvoyant(), Solvers.parse("clairvoyant"));
        assertEquals(new Heuristic(), Solvers.parse("heuristic"));
        assertEquals(new Greedy(), Solvers.parse("greedy"));
        assertEquals(new Qmdp(), Solvers.parse("qmdp"));
        assertEquals(new BurlapSparseSampling(2, 5), Solvers.parse("burlap:bss"));
        assertEquals(new BurlapSparseSampling(3, 4), Solvers.parse("burlap:bss,C=4,H=3"));
        assertEquals(new BurlapSparseSampling(3, 5), Solvers.parse("burlap:H=3"));
        assertEquals(new Confirm(), Solvers.parse("handover.solver.Confirm"));
    }

    @Test
    void aSolverIsFoundUnderItsOwnName() {
        for (Solver s : List.of(new Poss(2, 7, false), new Threshold(0.95), new Confirm(), new RandomActs(), new Clairvoyant())) {
            assertEquals(s, Solvers.parse(s.name()));
        }
        for (String name : Solvers.names()) {
            if (!name.equals("nearest")) { // which needs a file
                assertEquals(name, Solvers.parse(name).name().split(":")[0]);
            }
            assertFalse(Solvers.description(name).isBlank());
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            possum | expected one of poss, anytime, threshold, confirm, heuristic, greedy, qmdp, burlap, random, clairvoyant, nearest, or the full name of a class that \
            implements handover.solver.Solver
            `` | expected one of poss, anytime, threshold, confirm, heuristic, greedy, qmdp, burlap, random, clairvoyant, nearest, or the full name of a class that \
            implements handover.solver.Solver
            poss: | expected key=value with keys from H, C, leaf, threads, got nothing after the colon
            poss:H | expected key=value with keys from H, C, leaf, threads, got "H"
            poss:H=2, | expected key=value with keys from H, C, leaf, threads, got ""
            poss:h=2 | expected key=value with keys from H, C, leaf, threads, got "h=2"
            poss:H=2,H=3 | expected H once, got it twice
            poss:H=0 | H: expected a whole number from 1 to 100, got "0"
            poss:H=99999999999 | H: expected a whole number from 1 to 100, got "99999999999"
            poss:C=-1 | C: expected a whole number from 1 to 1000000, got "-1"
            poss:leaf=maybe | leaf: expected policy or zero, got "maybe"
            threshold:p=1.5 | p: expected a probability in [0, 1], got "1.5"
            threshold:p=NaN | p: expected a probability in [0, 1], got "NaN"
            threshold:p=high | p: expected a probability in [0, 1], got "high"
            confirm:p=1 | confirm has no parameters, got "p=1"
            no.such.Solver | there is no class of this name on the class path
            java.lang.String | this class does not implement handover.solver.Solver
            """)
    void whatCannotBeMeantIsSaid(String spec, String problem) {
        assertEquals("solver \"" + spec + "\": " + problem,
                assertThrows(Solvers.BadSolverException.class, () -> Solvers.parse(spec)).getMessage());
    }

    @Test
    void aClassWithoutItsConstructorIsRefused() {
        String message = assertThrows(Solvers.BadSolverException.class, () -> Solvers.parse("handover.solver.Poss")).getMessage();
        assertEquals("solver \"handover.solver.Poss\": expected a class with a public constructor without arguments",
                message.substring(0, message.lastIndexOf(": ", message.indexOf("arguments") + 11)));
    }
}
