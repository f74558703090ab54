package handover.domain;

/**
 * How people point (MODEL 4.2). Immutable.
 *
 * @param variance v of the angle between where they point and where the object is, rad^2
 * @param outliers eps_g, the share of gestures that mean nothing
 */
public record GestureParameters(double variance, double outliers) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public GestureParameters {
        Check.within("variance", variance, 1e-6, 1e3, "a variance in rad^2");
        Check.probability("outliers", outliers);
    }
}
