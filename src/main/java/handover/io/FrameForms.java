package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * The forms in which a file may give a frame: a rotation as a matrix of 3 rows or as a quaternion [x, y, z, w] with a
 * translation, or both in a matrix of 4 rows. All become the first.
 */
final class FrameForms {
    private static final String TABLE = "table";
    private static final String MATRIX = "matrix";
    private static final String ROTATION = "rotation";
    private static final String TRANSLATION = "translation";
    private static final double ROUNDING = 1e-3;

    private FrameForms() {}

    /** Rewrites the frames of a file (modified). Throws {@link DomainFileException} for what is none of the forms. */
    static void unify(JsonNode frames, Place at) {
        if (frames.has(TABLE)) {
            throw at.key(TABLE).error("expected another name, because this is the frame that the domain is in");
        }
        frames.properties().forEach(e -> {
            if (e.getValue() instanceof ObjectNode frame) {
                unifyOne(frame, at.key(e.getKey()));
            }
        });
    }

    private static void unifyOne(ObjectNode frame, Place at) {
        if (frame.has(MATRIX)) {
            if (frame.size() > 1) {
                throw at.key(MATRIX).error("expected either a matrix of 4 rows or rotation and translation");
            }
            split(frame, at.key(MATRIX));
        }
        if (!frame.has(TRANSLATION)) {
            frame.putArray(TRANSLATION).add(0.0).add(0.0).add(0.0);
        }
        JsonNode rotation = frame.get(ROTATION);
        if (rotation == null) {
            put(frame, new double[] {0, 0, 0, 1});
        } else if (rotation.isArray() && rotation.size() == 4) {
            put(frame, quaternion(rotation, at.key(ROTATION)));
        }
    }

    private static void split(ObjectNode frame, Place at) {
        JsonNode matrix = frame.remove(MATRIX);
        if (!matrix.isArray() || matrix.size() != 4) {
            throw at.expected("4 rows of 4 numbers", matrix);
        }
        ArrayNode rotation = frame.putArray(ROTATION);
        ArrayNode translation = frame.putArray(TRANSLATION);
        for (int i = 0; i < 4; i++) {
            JsonNode row = matrix.get(i);
            if (!row.isArray() || row.size() != 4) {
                throw at.at(i).expected("4 numbers", row);
            }
            if (i < 3) {
                rotation.addArray().add(row.get(0)).add(row.get(1)).add(row.get(2));
                translation.add(row.get(3));
            }
        }
        for (int j = 0; j < 4; j++) {
            if (matrix.get(3).get(j).asDouble(2) != (j == 3 ? 1 : 0)) {
                throw at.at(3).expected("[0, 0, 0, 1]", matrix.get(3));
            }
        }
    }

    private static double[] quaternion(JsonNode rotation, Place at) {
        double[] q = new double[4];
        double square = 0;
        for (int k = 0; k < 4; k++) {
            if (!rotation.get(k).isNumber()) {
                throw at.at(k).expected("a number", rotation.get(k));
            }
            q[k] = rotation.get(k).doubleValue();
            square += q[k] * q[k];
        }
        if (!(Math.abs(Math.sqrt(square) - 1) <= ROUNDING)) {
            throw at.expected("a quaternion [x, y, z, w] of length 1", rotation);
        }
        for (int k = 0; k < 4; k++) {
            q[k] /= Math.sqrt(square);
        }
        return q;
    }

    private static void put(ObjectNode frame, double[] q) {
        double x = q[0];
        double y = q[1];
        double z = q[2];
        double w = q[3];
        ArrayNode rows = frame.putArray(ROTATION);
        rows.addArray().add(1 - 2 * (y * y + z * z)).add(2 * (x * y - z * w)).add(2 * (x * z + y * w));
        rows.addArray().add(2 * (x * y + z * w)).add(1 - 2 * (x * x + z * z)).add(2 * (y * z - x * w));
        rows.addArray().add(2 * (x * z - y * w)).add(2 * (y * z + x * w)).add(1 - 2 * (x * x + y * y));
    }
}
