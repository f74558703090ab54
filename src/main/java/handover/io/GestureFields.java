package handover.io;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;

/** The fields of a gesture: where hand and shoulder are, as two positions or as joints of a skeleton. */
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
        Joints names = Joints.of(joints.node().fieldNames());
        if (!side.equals(BEST)) {
            return List.of(arm(joints, names, side));
        }
        List<WireMessage.Arm> arms = new ArrayList<>();
        for (String either : List.of("left", "right")) {
            if (names.hasArm(either)) {
                arms.add(arm(joints, names, either));
            }
        }
        return arms.isEmpty() ? List.of(arm(joints, names, "right")) : List.copyOf(arms);
    }

    private static WireMessage.Arm arm(Fields joints, Joints names, String side) {
        Vector3 hand = joints.vector(names.hand(side), METRES);
        return new WireMessage.Arm(hand, joints.vector(names.shoulder(side), METRES));
    }
}
