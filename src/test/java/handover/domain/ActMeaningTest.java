package handover.domain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** MODEL 3.1-3.3: lambda, M and U of every act, against the oracle and worked by hand. */
class ActMeaningTest {
    private static final double CLOSE = 1e-9;

    @Property(tries = 200, seed = "32", edgeCases = EdgeCasesMode.NONE)
    void lambdaAndMatchAreThoseOfTheText(@ForAll("specs") DomainSpec spec) {
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        for (ActModel model : new HandoverDomain(spec).start().acts()) {
            Act act = model.act();
            assertArrayEquals(each(oracle, i -> oracle.lambda(act, i)), model.lambda(), CLOSE, () -> "lambda of " + act);
            if (act.equals(Act.WAIT)) {
                assertNull(model.match(), "WAIT refers to nothing by itself");
            } else {
                assertArrayEquals(each(oracle, i -> oracle.match(act, i)), model.match(), CLOSE, () -> "M of " + act);
            }
        }
    }

    @Property(tries = 200, seed = "33", edgeCases = EdgeCasesMode.NONE)
    void theHumansBeliefMovesAsInTheText(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        double[] h = AnyDomain.simplex(oracle.n(), random);
        for (ActModel model : domain.start().acts()) {
            double[] before = h.clone();
            double[] expected = oracle.understood(h, model.act());
            assertArrayEquals(expected, domain.understood(model, h), CLOSE, () -> "U(h, " + model + ")");
            assertArrayEquals(before, h, 0, "h was modified");
        }
    }

    @Property(tries = 100, seed = "34", edgeCases = EdgeCasesMode.NONE)
    void actsOfOneTypeShareTheirLambda(@ForAll("specs") DomainSpec spec) {
        HandoverDomain domain = new HandoverDomain(spec);
        for (ActType type : domain.types()) {
            for (int i = 0; i < domain.start().size(); i++) {
                int object = i;
                double sum = domain.start().acts().stream().filter(m -> m.type() == type)
                        .mapToDouble(m -> m.lambda()[object]).sum();
                assertEquals(1, sum, CLOSE, () -> type.verb() + " given object " + object);
            }
        }
    }

    @Test
    void twoObjectsByHand() {
        // At right angles as seen from the origin: theta = pi/2. Words: "red" 3 of 4 for a, 1 of 4 for b (alpha 0).
        TableObject a = new TableObject("a", new Vector3(1, 0, 0.3), Map.of("red", 3.0, "box", 1.0), "red");
        TableObject b = new TableObject("b", new Vector3(0, 2, 0.3), Map.of("red", 1.0, "box", 3.0), "box");
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", List.of(a, b)).with(s -> {
            s.tauHuman = 0.5;
            s.understanding = new Understanding(1, 0.162, 0.2);
            s.speech = new SpeechParameters(0, 0.05, 0, 0, 0.01, List.of(1.0));
        }));
        double g = Math.exp(-Math.PI * Math.PI / 8);
        assertArrayEquals(new double[] {1 / (1 + g), g / (1 + g)}, lambda(domain, "POINT"), 1e-14);
        assertArrayEquals(new double[] {0.75, 0.25}, lambda(domain, "ASK"), 1e-14);
        assertArrayEquals(new double[] {0.8, 0.2}, lambda(domain, "PICK"), 1e-14);
        // tau_H = 1/2 of two forgets everything, so h' is lambda itself.
        assertArrayEquals(new double[] {0.75, 0.25},
                domain.understood(domain.start().model(Act.of("ASK", "a")), new double[] {0, 1}), 1e-14);
    }

    private static double[] lambda(HandoverDomain domain, String verb) {
        return domain.start().model(Act.of(verb, "a")).lambda();
    }

    private static double[] each(ModelOracle oracle, java.util.function.IntToDoubleFunction of) {
        return IntStream.range(0, oracle.n()).mapToDouble(of).toArray();
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
