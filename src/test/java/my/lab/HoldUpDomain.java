package my.lab;

import handover.domain.Act;
import handover.domain.ActParameters;
import handover.domain.ActType;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import java.util.ArrayList;
import java.util.List;

/** A robot with two hands can also hold up two objects: HOLD_UP(x,y), "one of these?". */
public class HoldUpDomain extends HandoverDomain {
    public HoldUpDomain(DomainSpec spec) {
        super(spec);
    }

    public static DomainSpec defaults(DomainSpec base) {
        return base.with(s -> s.acts.put("hold_up", new ActParameters(-2, 2, 0.5, 0.3, 0.9, 0.9)));
    }

    @Override
    protected List<ActType> actTypes() {
        List<ActType> all = new ArrayList<>(super.actTypes());
        all.add(new HoldUp(spec().act("hold_up")));
        return all;
    }

    private static final class HoldUp extends ActType {
        HoldUp(ActParameters parameters) {
            super("HOLD_UP", parameters);
        }

        @Override
        public List<Act> acts(List<TableObject> present) {
            List<Act> pairs = new ArrayList<>();
            for (int i = 0; i < present.size(); i++) {
                for (int j = i + 1; j < present.size(); j++) {
                    pairs.add(Act.of("HOLD_UP", present.get(i).name(), present.get(j).name()));
                }
            }
            return pairs;
        }

        @Override
        public String say(Act act, List<TableObject> present) {
            return "one of these?";
        }

        @Override
        public double[] match(Act act, List<TableObject> present) {
            return present.stream().mapToDouble(o -> act.objects().contains(o.name()) ? 1 : 0).toArray();
        }

        @Override
        public double[] weights(Act act, List<TableObject> present) {
            return present.stream().mapToDouble(o -> act.objects().contains(o.name()) ? 1 : 0.02).toArray();
        }
    }
}
