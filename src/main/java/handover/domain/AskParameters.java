package handover.domain;

/**
 * What the robot may ask about.
 *
 * @param sets which sets of objects a question may be about
 */
public record AskParameters(AskSets sets) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public AskParameters {
        Check.present("sets", sets, "singletons or attributes");
    }
}
