package my.lab;

import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Task;

/** Somebody sleeps next door: whatever is said aloud costs 1.5 more. */
public class QuietDomain extends HandoverDomain {
    public QuietDomain(DomainSpec spec) {
        super(spec);
    }

    @Override
    public double actReward(Task before, ActModel act) {
        return super.actReward(before, act) - (act.say().isEmpty() ? 0 : 1.5);
    }
}
