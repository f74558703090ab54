package handover.domain;

import java.util.List;

/** WAIT: do nothing and listen. */
public final class WaitType extends ActType {
    public static final String VERB = "WAIT";

    public WaitType(ActParameters parameters) {
        super(VERB, parameters);
    }

    @Override
    public List<Act> acts(List<TableObject> present) {
        return List.of(Act.WAIT);
    }
}
