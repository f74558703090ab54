package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.solver.Decision;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Times as they are written, and what is drawn from them. */
class PlanningLatencyTest {
    private static final Decision DECISION = new Decision(Act.WAIT, Map.of(), 2, 5000, true);
    private static final RandomGenerator NO_CHANCE = () -> {
        throw new AssertionError("a fixed time needs no chance");
    };

    private static double seconds(String model) {
        return PlanningLatency.parse(model).seconds(DECISION, NO_CHANCE);
    }

    @Test
    void readsWhatPeopleWrite() {
        assertEquals(2, seconds("2s"));
        assertEquals(0.01, seconds("10ms"));
        assertEquals(0, seconds("0s"));
        assertEquals(1.5, seconds("1.5s"));
        assertEquals(3600, seconds("3600s"));
        assertEquals(0.025, seconds("nodes:200000/s"));
        assertEquals(10000, seconds("nodes:0.5/s"));
        assertEquals(new Delay.LogNormal(0.5, 0.4), PlanningLatency.parse("lognormal:median=500ms,sigma=0.4"));
        assertEquals(new Delay.LogNormal(2, 1), Delay.parse("lognormal:median=2s,sigma=1"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "2", "s", "-1s", "2 s", "2m", "1e3s", "NaNs", "2s ", "3601s", "lognormal", "lognormal:median=2s",
        "lognormal:sigma=1,median=2s", "lognormal:median=2s,sigma=4", "lognormal:median=2s,sigma=-1", "nodes:0/s", "nodes:-5/s", "nodes:5",
        "nodes:1e9/s", "measured", "nodes:/s"})
    void refusesTheRest(String text) {
        String problem = assertThrows(IllegalArgumentException.class, () -> PlanningLatency.parse(text)).getMessage();
        assertTrue(problem.startsWith("expected ") && problem.contains(", got "), problem);
        assertThrows(IllegalArgumentException.class, () -> Delay.parse(text));
    }

    @Test
    void aReactionIsNotCountedInNodes() {
        assertEquals("expected a time such as 2s or 10ms, lognormal:median=2s,sigma=0.3, got \"nodes:5/s\"",
                assertThrows(IllegalArgumentException.class, () -> Delay.parse("nodes:5/s")).getMessage());
    }

    /**
     * Of 10,000 draws as many below the quantile as there should be, to 5 standard deviations: false alarm below 1e-6 a
     * quantile. 0.7 below and above the median are the quantiles of -1 and 1 standard deviations of the logarithm.
     */
    @Test
    void logNormalTimesHaveTheirQuantiles() {
        RandomGenerator random = new SplittableRandom(5);
        Delay delay = new Delay.LogNormal(2, 0.7);
        double[] drawn = new double[10_000];
        Arrays.setAll(drawn, k -> delay.seconds(random));
        double[][] quantiles = {{2 * Math.exp(-0.7), 0.158655}, {2, 0.5}, {2 * Math.exp(0.7), 0.841345}};
        for (double[] q : quantiles) {
            double below = Arrays.stream(drawn).filter(x -> x < q[0]).count() / 1e4;
            assertEquals(q[1], below, 5 * Math.sqrt(q[1] * (1 - q[1]) / 1e4), "below " + q[0]);
        }
        assertEquals(3600, new Delay.LogNormal(3600, 0).seconds(random));
        assertTrue(new Delay.LogNormal(3600, 3).seconds(random) <= 3600);
    }
}
