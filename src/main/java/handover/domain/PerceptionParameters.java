package handover.domain;

/**
 * How well people perceive the robot's questions, points and looks (MODEL 8). A pick is always perceived ("an indisputable
 * sign" [R]). Immutable.
 *
 * @param missed probability that such an act is not noticed: to the human the robot waits
 * @param misread probability that it is taken for the act of its type that is most like it; at most 1 - {@code missed}
 * @param minds how many different states of the human's mind the robot's belief keeps apart, at least 1; without effect on
 *     people
 */
public record PerceptionParameters(double missed, double misread, int minds) {
    /** Every act is perceived as it was meant. */
    public static final PerceptionParameters EXACT = new PerceptionParameters(0, 0, 50);

    /** Checks every field; throws {@link InvalidParameterException}. */
    public PerceptionParameters {
        Check.probability("missed", missed);
        Check.probability("misread", misread);
        if (missed + misread > 1) {
            throw new InvalidParameterException("misread", misread, "at most 1 - missed = " + (1 - missed));
        }
        Check.within("minds", minds, 1, 100_000, "a count");
    }

    /** The same people with other probabilities. */
    public PerceptionParameters with(double missing, double misreading) {
        return new PerceptionParameters(missing, misreading, minds);
    }

    /** Whether every act is perceived as it was meant. */
    public boolean exact() {
        return missed == 0 && misread == 0;
    }
}
