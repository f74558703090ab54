package handover.bridge;

import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;

/** A variant with a mistake in it: it throws when the robot looks. Public as the bridge makes it by its name. */
public final class FaultyDomain extends HandoverDomain {
    public FaultyDomain(DomainSpec spec) {
        super(spec);
    }

    @Override
    public void understand(ActModel act, double[] h, double[] out, int n) {
        if (act.act().verb().equals("LOOK")) {
            throw new IllegalStateException("broken on purpose");
        }
        super.understand(act, h, out, n);
    }
}
