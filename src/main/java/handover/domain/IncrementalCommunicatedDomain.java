package handover.domain;

/** The incremental pick with the reward of the pair &lt;omega_R, omega_H&gt;. Immutable, thread safe. */
public class IncrementalCommunicatedDomain extends CommunicatedObjectDomain {
    /** As {@link HandoverDomain#HandoverDomain}. */
    public IncrementalCommunicatedDomain(DomainSpec spec) {
        super(spec);
    }

    /** As {@link IncrementalPickDomain#defaults}. */
    public static DomainSpec defaults(DomainSpec base) {
        return IncrementalPickDomain.defaults(base);
    }

    @Override
    protected PickRule createPickRule() {
        return PickRule.incremental(spec().pick());
    }
}
