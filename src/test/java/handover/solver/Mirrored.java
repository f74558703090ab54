package handover.solver;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;

/** Two cups left and right of a bowl, seen from the middle: the cups can be swapped, and so can their colours. */
final class Mirrored {
    private Mirrored() {}

    static DomainSpec spec() {
        List<TableObject> objects = List.of(
                new TableObject("left_cup", new Vector3(-0.2, 0.6, 0), Map.of("red", 2.0, "cup", 3.0), "red cup"),
                new TableObject("bowl", new Vector3(0, 0.6, 0), Map.of("bowl", 4.0), "bowl"),
                new TableObject("right_cup", new Vector3(0.2, 0.6, 0), Map.of("blue", 2.0, "cup", 3.0), "blue cup"));
        return DomainSpec.of("mirrored", objects).with(s -> s.shoulder = new Vector3(0, 1.4, 0.35));
    }

    static HandoverDomain domain() {
        return new HandoverDomain(spec());
    }
}
