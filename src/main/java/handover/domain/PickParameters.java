package handover.domain;

/**
 * How a pick goes on in the variants in which it takes several increments (MODEL 5). Immutable.
 *
 * @param increments K, how often a pick is chosen before it completes, at least 1
 * @param advance probability that an increment advances
 */
public record PickParameters(int increments, double advance) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public PickParameters {
        Check.within("increments", increments, 1, 100, "a count");
        if (!(advance > 0 && advance <= 1)) {
            throw new InvalidParameterException("advance", advance, "a probability above 0");
        }
    }
}
