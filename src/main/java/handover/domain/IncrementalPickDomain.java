package handover.domain;

/**
 * The incremental pick (MODEL 2, 5): PICK must be chosen K times, anything else cancels it, and each increment shows the
 * human what is coming, who then objects or stays silent. Immutable, thread safe.
 *
 * <p>Source: "Progress Report: Social Feedback for Robotic Collaboration", section 2.2.
 */
public class IncrementalPickDomain extends HandoverDomain {
    /** As {@link HandoverDomain#HandoverDomain}. */
    public IncrementalPickDomain(DomainSpec spec) {
        super(spec);
    }

    /** The defaults of this variant: people speak up when the robot reaches for something else (kappa_s = 0.3). */
    public static DomainSpec defaults(DomainSpec base) {
        return base.with(s -> s.speech = base.speech().withSurprise(0.3));
    }

    @Override
    protected PickRule createPickRule() {
        return PickRule.incremental(spec().pick());
    }
}
