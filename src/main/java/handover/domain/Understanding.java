package handover.domain;

/**
 * How precisely people read the robot's acts (MODEL 3.1). Immutable.
 *
 * @param sigmaPoint standard deviation of a point's direction as people see it, rad
 * @param sigmaLook the same of a look, rad
 * @param pickError eps_pick, the probability that a pick is not of what the human wants, as the human sees it
 */
public record Understanding(double sigmaPoint, double sigmaLook, double pickError) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public Understanding {
        Check.within("sigma_point", sigmaPoint, 1e-4, Math.PI, "radians");
        Check.within("sigma_look", sigmaLook, 1e-4, Math.PI, "radians");
        Check.probability("pick_error", pickError);
    }
}
