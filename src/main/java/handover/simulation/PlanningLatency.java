package handover.simulation;

import handover.solver.Decision;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.random.RandomGenerator;

/** How much virtual time a decision takes. Immutable, thread safe. */
public sealed interface PlanningLatency permits Delay, PlanningLatency.PerNode {

    /** Seconds that this decision took, at least 0; all chance is from {@code random}. */
    double seconds(Decision decision, RandomGenerator random);

    /**
     * Reads {@code nodes:200000/s}, or what {@link Delay#parse} reads.
     *
     * @throws IllegalArgumentException that says what was expected
     */
    static PlanningLatency parse(String text) {
        Matcher m = PerNode.FORM.matcher(text);
        if (!m.matches()) {
            return Delay.parse(text, ", or nodes:200000/s");
        }
        return new PerNode(Double.parseDouble(m.group(1)));
    }

    /**
     * A planner that visits so many beliefs in a second, whatever the computer on which this is simulated.
     *
     * @param perSecond {@link Decision#nodes} a second, above 0
     */
    record PerNode(double perSecond) implements PlanningLatency {
        private static final Pattern FORM = Pattern.compile("nodes:([0-9]{1,12}(?:\\.[0-9]{1,9})?)/s");

        /** Throws {@link IllegalArgumentException} unless the rate is positive. */
        public PerNode {
            if (!(perSecond > 0 && perSecond < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("expected more than 0 nodes/s, got " + perSecond);
            }
        }

        @Override
        public double seconds(Decision decision, RandomGenerator random) {
            return decision.nodes() / perSecond;
        }
    }
}
