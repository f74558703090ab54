package handover.io;

import handover.math.Vector3;
import java.util.List;
import java.util.stream.Stream;

/** The fields of a gesture: where hand and shoulder are, as two positions or as joints of a skeleton. */
final class GestureFields {
    private static final String METRES = "number of metres";

    private GestureFields() {}

    static WireMessage read(WireMessage.Envelope envelope, Fields f) {
        if (f.has("confidence")) {
            f.number("confidence", 0, 1, "a confidence");
        }
        String frame = f.textOrNull("frame");
        if (!f.has("joints")) {
            Vector3 hand = f.vector("hand", METRES);
            return new WireMessage.Pointed(envelope, hand, f.vector("shoulder", METRES), frame);
        }
        if (f.has("hand") || f.has("shoulder")) {
            throw f.wrong("joints", "either hand and shoulder or joints");
        }
        String side = "_" + f.oneOf("side", List.of("left", "right"));
        Fields joints = f.object("joints");
        String hand = Stream.of("hand", "wrist").map(j -> j + side).filter(joints::has).findFirst().orElse("hand" + side);
        return new WireMessage.Pointed(envelope, joints.vector(hand, METRES), joints.vector("shoulder" + side, METRES), frame);
    }
}
