package handover.domain;

import handover.math.Vector3;

/** Range checks of parameter records. Each returns the value or throws {@link InvalidParameterException}. */
final class Check {
    private static final double FAR = 100;
    /** Directions to things closer than this are undefined for all practical purposes, in metres. */
    static final double TOO_CLOSE = 0.01;

    private Check() {}

    static double within(String field, double value, double low, double high, String meaning) {
        if (!(value >= low && value <= high)) {
            throw new InvalidParameterException(field, value, meaning + " in [" + show(low) + ", " + show(high) + "]");
        }
        return value;
    }

    static double probability(String field, double value) {
        return within(field, value, 0, 1, "a probability");
    }

    static Vector3 position(String field, Vector3 p) {
        if (p == null) {
            throw new InvalidParameterException(field, null, "[x, y, z] in metres");
        }
        double[] xyz = {p.x(), p.y(), p.z()};
        for (int k = 0; k < 3; k++) {
            within(field + "[" + k + "]", xyz[k], -FAR, FAR, "metres");
        }
        return p;
    }

    static <T> T present(String field, T value, String expected) {
        if (value == null) {
            throw new InvalidParameterException(field, null, expected);
        }
        return value;
    }

    private static String show(double x) {
        return x == Math.rint(x) && Math.abs(x) < 1e7 ? Long.toString((long) x) : Double.toString(x);
    }
}
