package handover.bridge;

import handover.domain.DomainSpec;
import handover.domain.Frame;
import handover.domain.InvalidParameterException;
import handover.domain.TableObject;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Vector3;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** Positions in the frames of the domain file, mapped to the table's. Stateless. */
final class Frames {
    private static final String TABLE = "table";

    private Frames() {}

    /** What maps positions of a frame (null for the table's) to the table. Throws {@link WireException} if it is unknown. */
    static UnaryOperator<Vector3> toTable(String name, DomainSpec spec) {
        if (name == null || name.equals(TABLE)) {
            return p -> p;
        }
        Frame frame = spec.frames().get(name);
        if (frame == null) {
            throw new WireException(WireCode.UNKNOWN_FRAME, "frame", "expected " + TABLE
                    + (spec.frames().isEmpty() ? "" : " or one of " + String.join(", ", spec.frames().keySet()))
                    + ", got \"" + name + "\"");
        }
        return frame::toTable;
    }

    /** The same change with positions in the table's frame. */
    static WireMessage.SceneChange toTable(WireMessage.SceneChange change, DomainSpec spec) {
        UnaryOperator<Vector3> map = toTable(change.frame(), spec);
        Map<String, Vector3> moved = new LinkedHashMap<>();
        change.moved().forEach((name, p) -> moved.put(name, map.apply(p)));
        try {
            List<TableObject> added = change.added().stream().map(o -> o.at(map.apply(o.position()))).toList();
            return new WireMessage.SceneChange(change.envelope(), moved, change.removed(), added, null);
        } catch (InvalidParameterException e) {
            throw new WireException(WireCode.BAD_FIELD, "added", e.getMessage());
        }
    }
}
