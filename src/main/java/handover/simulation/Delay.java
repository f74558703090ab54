package handover.simulation;

import handover.solver.Decision;
import java.util.random.RandomGenerator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A time span, fixed or drawn. Immutable, thread safe. */
public sealed interface Delay extends PlanningLatency {
    /** The longest, seconds. */
    double LONGEST = 3600;

    /** Seconds, from 0 to {@link #LONGEST}. */
    double seconds(RandomGenerator random);

    @Override
    default double seconds(Decision decision, RandomGenerator random) {
        return seconds(random);
    }

    /**
     * Reads {@code 2s}, {@code 10ms} or {@code lognormal:median=2s,sigma=0.3}.
     *
     * @throws IllegalArgumentException that says what was expected
     */
    static Delay parse(String text) {
        return parse(text, "");
    }

    /** The same, where more than this is possible. */
    static Delay parse(String text, String more) {
        Matcher drawn = LogNormal.FORM.matcher(text);
        return drawn.matches() ? new LogNormal(span(drawn.group(1), drawn.group(2)), Double.parseDouble(drawn.group(3)))
                : Fixed.parse(text, ", lognormal:median=2s,sigma=0.3" + more);
    }

    private static double span(String number, String unit) {
        return Double.parseDouble(number) / (unit.equals("ms") ? 1000 : 1);
    }

    private static void check(boolean holds, String expected, double got) {
        if (!holds) {
            throw new IllegalArgumentException("expected " + expected + ", got " + got);
        }
    }

    /**
     * Always the same.
     *
     * @param span seconds, from 0 to {@link #LONGEST}
     */
    record Fixed(double span) implements Delay {
        private static final Pattern FORM = Pattern.compile("([0-9]{1,9}(?:\\.[0-9]{1,9})?)(ms|s)");

        /** Reads {@code 2s} or {@code 10ms}, where {@code more} is possible; throws as {@link Delay#parse(String)}. */
        public static Fixed parse(String text, String more) {
            Matcher fixed = FORM.matcher(text);
            if (!fixed.matches()) {
                throw new IllegalArgumentException("expected a time such as 2s or 10ms" + more + ", got \"" + text + "\"");
            }
            return new Fixed(Delay.span(fixed.group(1), fixed.group(2)));
        }

        /** Throws {@link IllegalArgumentException} for a span outside its range. */
        public Fixed {
            check(span >= 0 && span <= LONGEST, "0 to " + LONGEST + " s", span);
        }

        @Override
        public double seconds(RandomGenerator random) {
            return span;
        }
    }

    /**
     * A log-normal span, as reaction times are; cut off at {@link #LONGEST}.
     *
     * @param median seconds, from 0 to {@link #LONGEST}
     * @param sigma standard deviation of the logarithm, from 0 to 3
     */
    record LogNormal(double median, double sigma) implements Delay {
        private static final Pattern FORM = Pattern.compile("lognormal:median=" + Fixed.FORM + ",sigma=([0-9](?:\\.[0-9]{1,9})?)");

        /** Throws {@link IllegalArgumentException} for parameters outside their ranges. */
        public LogNormal {
            check(median >= 0 && median <= LONGEST, "a median of 0 to " + LONGEST + " s", median);
            check(sigma >= 0 && sigma <= 3, "a sigma of 0 to 3", sigma);
        }

        @Override
        public double seconds(RandomGenerator random) {
            return Math.min(LONGEST, median * Math.exp(sigma * random.nextGaussian()));
        }
    }
}
