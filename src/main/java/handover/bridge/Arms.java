package handover.bridge;

import handover.domain.Gesture;
import handover.domain.InvalidParameterException;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Vector3;
import java.util.function.UnaryOperator;

/** Which of two arms points. Stateless. */
final class Arms {
    private Arms() {}

    /**
     * The gesture of the arm that points, in the table's frame: of two, the one whose direction is nearest to some object; the
     * other one hangs or is busy elsewhere.
     *
     * @throws WireException for a frame that is not known, or positions that have no direction
     */
    static Gesture gesture(WireMessage.Pointed message, Scene scene) {
        UnaryOperator<Vector3> map = Frames.toTable(message.frame(), scene.domain().spec());
        Gesture best = null;
        InvalidParameterException unusable = null;
        for (WireMessage.Arm arm : message.arms()) {
            try {
                Gesture gesture = Gesture.of(map.apply(arm.shoulder()), map.apply(arm.hand()));
                best = best == null || nearest(gesture, scene) < nearest(best, scene) ? gesture : best;
            } catch (InvalidParameterException e) {
                unusable = e;
            }
        }
        if (best == null) {
            throw new WireException(WireCode.BAD_FIELD, unusable.field(), unusable.problem());
        }
        return best;
    }

    /** Radians between the gesture and the direction to the object that it is nearest to. */
    private static double nearest(Gesture gesture, Scene scene) {
        double nearest = Math.PI;
        for (TableObject o : scene.objects()) {
            nearest = Math.min(nearest, gesture.direction().angleTo(o.position().minus(gesture.shoulder())));
        }
        return nearest;
    }
}
