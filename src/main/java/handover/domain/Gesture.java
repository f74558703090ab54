package handover.domain;

import handover.math.Vector3;

/**
 * Where the human pointed. Immutable.
 *
 * @param shoulder metres, table frame
 * @param direction shoulder to hand, unit length
 */
public record Gesture(Vector3 shoulder, Vector3 direction) {
    /** A hand closer than this to the shoulder points nowhere, metres. */
    public static final double SHORTEST_ARM = 1e-3;

    /** What is unit length up to rounding stays as it is, so that a gesture that was written can be read again. */
    private static final double ROUNDING = 1e-12;

    /** Makes {@code direction} unit length; throws {@link InvalidParameterException} if it has no direction. */
    public Gesture {
        Check.position("shoulder", shoulder);
        double length = direction.norm();
        if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
            throw new InvalidParameterException("direction", direction, "a finite vector that is not zero");
        }
        direction = Math.abs(length - 1) < ROUNDING ? direction : direction.unit();
    }

    /** The gesture of a hand seen from a shoulder, both in metres. */
    public static Gesture of(Vector3 shoulder, Vector3 hand) {
        Check.position("hand", hand);
        Vector3 arm = hand.minus(shoulder);
        if (arm.norm() < SHORTEST_ARM) {
            throw new InvalidParameterException("hand", hand, "a hand at least " + SHORTEST_ARM + " m from the shoulder");
        }
        return new Gesture(shoulder, arm);
    }
}
