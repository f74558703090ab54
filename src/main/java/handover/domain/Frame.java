package handover.domain;

import handover.math.Vector3;
import java.util.List;

/**
 * Where another frame lies: what is at p there is at R p + translation in the table's frame. Immutable.
 *
 * @param rotation R by rows, three of three numbers: orthonormal and right-handed
 * @param translation origin of the other frame, metres, table frame
 */
public record Frame(List<List<Double>> rotation, Vector3 translation) {
    private static final int AXES = 3;
    private static final double ROUNDING = 1e-3;

    /** Checks that this is a rigid motion, up to the digits that people write; throws {@link InvalidParameterException}. */
    public Frame {
        Check.position("translation", translation);
        if (rotation.size() != AXES || rotation.stream().anyMatch(row -> row.size() != AXES)) {
            throw new InvalidParameterException("rotation", "expected 3 rows of 3 numbers, or a quaternion [x, y, z, w]");
        }
        rotation = rotation.stream().map(List::copyOf).toList();
        for (int i = 0; i < AXES; i++) {
            for (int j = i; j < AXES; j++) {
                double product = row(rotation, i).dot(row(rotation, j));
                if (!(Math.abs(product - (i == j ? 1 : 0)) <= ROUNDING)) {
                    throw new InvalidParameterException("rotation", "expected rows of length 1 at right angles, got a product of "
                            + product + " of rows " + i + " and " + j);
                }
            }
        }
        if (row(rotation, 0).cross(row(rotation, 1)).dot(row(rotation, 2)) < 0) {
            throw new InvalidParameterException("rotation", "expected a rotation, got one that mirrors");
        }
    }

    private static Vector3 row(List<List<Double>> rotation, int i) {
        List<Double> row = rotation.get(i);
        return new Vector3(row.get(0), row.get(1), row.get(2));
    }

    /** A position of this frame in the table's frame, metres. */
    public Vector3 toTable(Vector3 p) {
        return new Vector3(row(rotation, 0).dot(p), row(rotation, 1).dot(p), row(rotation, 2).dot(p)).plus(translation);
    }
}
