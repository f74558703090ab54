package handover.theory;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** psi against 17 digits (mpmath), its recurrence, and its inverse. */
class DigammaTest {
    @ParameterizedTest
    @CsvSource({"1, -0.57721566490153286", "0.5, -1.9635100260214235", "49.5, 3.89183765072637178", "1e-4, -10000.5770511835143",
            "1e-5, -100000.577199215681", "0.05, -20.4978449912998704", "500, 6.21360776508899174", "12, 2.44266167997581202"})
    void knownValues(double x, double psi) {
        assertEquals(psi, Digamma.of(x), 2e-15 * Math.max(1, Math.abs(psi)));
    }

    @Property(tries = 200)
    void recurrence(@ForAll @DoubleRange(min = 0.01, max = 1e4) double x) {
        assertEquals(Digamma.of(x) + 1 / x, Digamma.of(x + 1), 1e-13 * Math.max(1, 1 / x));
    }

    @Property(tries = 200)
    void inverse(@ForAll @DoubleRange(min = -1e4, max = 15) double y) {
        assertEquals(y, Digamma.of(DirichletFit.inverseDigamma(y)), 1e-12 * Math.max(1, Math.abs(y)));
    }
}
