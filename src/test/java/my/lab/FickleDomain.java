package my.lab;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;

/** People who come to want something else now and then. */
public class FickleDomain extends HandoverDomain {
    public FickleDomain(DomainSpec spec) {
        super(spec);
    }

    public static DomainSpec defaults(DomainSpec base) {
        return base.with(s -> s.tau = 0.95);
    }
}
