package handover.io;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The fields of a gesture: where hand and shoulder are, as two positions or as joints of a skeleton. Joints that are null are not
 * tracked, as if they were missing; of two arms one may be unusable.
 */
final class GestureFields {
    private static final String METRES = "number of metres";
    private static final String BEST = "best";

    private GestureFields() {}

    static WireMessage read(WireMessage.Envelope envelope, Fields f) {
        if (f.has("confidence")) {
            f.number("confidence", 0, 1, "a confidence");
        }
        return new WireMessage.Pointed(envelope, f.has("joints") ? joints(f) : List.of(handAndShoulder(f)),
                f.textOrNull("frame"));
    }

    private static WireMessage.Arm handAndShoulder(Fields f) {
        Vector3 hand = f.vector("hand", METRES);
        return new WireMessage.Arm(hand, f.vector("shoulder", METRES));
    }

    private static List<WireMessage.Arm> joints(Fields f) {
        if (f.has("hand") || f.has("shoulder")) {
            throw f.wrong("joints", "either hand and shoulder or joints");
        }
        String side = f.has("side") ? f.oneOf("side", List.of("left", "right", BEST)) : BEST;
        Fields joints = f.object("joints");
        Joints names = Joints.of(joints.node().properties().stream().filter(j -> !j.getValue().isNull()).map(Map.Entry::getKey));
        if (!side.equals(BEST)) {
            return List.of(arm(joints, names, side));
        }
        List<String> tracked = Stream.of("left", "right").filter(names::hasArm).toList();
        List<WireMessage.Arm> arms = new ArrayList<>();
        FieldException unusable = null;
        for (String either : tracked.isEmpty() ? List.of("right") : tracked) {
            try {
                arms.add(arm(joints, names, either));
            } catch (FieldException e) {
                unusable = unusable == null ? e : unusable;
            }
        }
        if (arms.isEmpty()) {
            throw unusable;
        }
        return List.copyOf(arms);
    }

    private static WireMessage.Arm arm(Fields joints, Joints names, String side) {
        Vector3 hand = joints.vector(names.hand(side), METRES);
        return new WireMessage.Arm(hand, joints.vector(names.shoulder(side), METRES));
    }
}
