package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * One JSON object, read field by field and strictly: each reader throws {@link FieldException} if the field is missing (null
 * counts as missing) or is not what it should be. Fields that nobody reads are let be, so that formats may grow.
 *
 * @param node the object
 * @param path where it is; empty for the whole
 */
record Fields(JsonNode node, String path) {

    Fields {
        if (!node.isObject()) {
            throw wrong(path, "an object {...}", node);
        }
    }

    boolean has(String key) {
        return node.hasNonNull(key);
    }

    String text(String key) {
        return text(required(key), at(key));
    }

    /** A text, or null if it is missing. */
    String textOrNull(String key) {
        return has(key) ? text(key) : null;
    }

    String oneOf(String key, List<String> words) {
        JsonNode value = required(key);
        if (!value.isTextual() || !words.contains(value.textValue())) {
            throw wrong(at(key), "one of " + String.join(", ", words), value);
        }
        return value.textValue();
    }

    boolean flag(String key) {
        JsonNode value = required(key);
        if (!value.isBoolean()) {
            throw wrong(at(key), "true or false", value);
        }
        return value.booleanValue();
    }

    long whole(String key, long low, long high) {
        JsonNode value = required(key);
        if (!value.isIntegralNumber() || !value.canConvertToLong() || value.longValue() < low || value.longValue() > high) {
            throw wrong(at(key), low == Long.MIN_VALUE ? "a whole number" : "a whole number from " + low + " to " + high,
                    value);
        }
        return value.longValue();
    }

    double number(String key) {
        return number(required(key), at(key), "number");
    }

    /** @param what the value is, for messages: "a probability" */
    double number(String key, double low, double high, String what) {
        return within(required(key), at(key), low, high, what);
    }

    double[] numbers(String key) {
        JsonNode list = list(key);
        double[] values = new double[list.size()];
        for (int k = 0; k < values.length; k++) {
            values[k] = number(list.get(k), at(key, k), "number");
        }
        return values;
    }

    /** [x, y, z], in what the words say. */
    Vector3 vector(String key, String what) {
        JsonNode list = required(key);
        if (!list.isArray() || list.size() != 3) {
            throw wrong(at(key), "[x, y, z]", list);
        }
        return new Vector3(number(list.get(0), at(key, 0), what), number(list.get(1), at(key, 1), what),
                number(list.get(2), at(key, 2), what));
    }

    List<String> texts(String key) {
        JsonNode list = list(key);
        List<String> values = new ArrayList<>();
        for (int k = 0; k < list.size(); k++) {
            values.add(text(list.get(k), at(key, k)));
        }
        return values;
    }

    Fields object(String key) {
        return new Fields(required(key), at(key));
    }

    List<Fields> objects(String key) {
        JsonNode list = list(key);
        List<Fields> values = new ArrayList<>();
        for (int k = 0; k < list.size(); k++) {
            values.add(new Fields(list.get(k), at(key, k)));
        }
        return values;
    }

    /** The fields of an object whose values are all probabilities. */
    Map<String, Double> probabilities(String key) {
        return object(key).probabilities();
    }

    /** This object, whose values are all probabilities. */
    Map<String, Double> probabilities() {
        Map<String, Double> values = new LinkedHashMap<>();
        node.properties().forEach(e -> values.put(e.getKey(), within(e.getValue(), at(e.getKey()), 0, 1, "a probability")));
        return values;
    }

    FieldException wrong(String key, String expected) {
        return wrong(at(key), expected, node.get(key));
    }

    private JsonNode required(String key) {
        if (!has(key)) {
            throw new FieldException(true, at(key), "this field is missing");
        }
        return node.get(key);
    }

    private JsonNode list(String key) {
        JsonNode value = required(key);
        if (!value.isArray()) {
            throw wrong(at(key), "a list [...]", value);
        }
        return value;
    }

    private String at(String key) {
        return (path.isEmpty() ? "" : path + ".") + Place.shown(key);
    }

    private String at(String key, int index) {
        return at(key) + "[" + index + "]";
    }

    private static String text(JsonNode value, String path) {
        if (!value.isTextual()) {
            throw wrong(path, "text in double quotes", value);
        }
        return value.textValue();
    }

    private static double number(JsonNode value, String path, String what) {
        if (!value.isNumber() || !Double.isFinite(value.doubleValue())) {
            throw wrong(path, "a finite " + what, value);
        }
        return value.doubleValue();
    }

    private static double within(JsonNode value, String path, double low, double high, String what) {
        if (!value.isNumber() || !(value.doubleValue() >= low && value.doubleValue() <= high)) {
            throw wrong(path, what + " in [" + shown(low) + ", " + shown(high) + "]", value);
        }
        return value.doubleValue();
    }

    private static String shown(double bound) {
        return bound == Math.rint(bound) ? Long.toString((long) bound) : Double.toString(bound);
    }

    private static FieldException wrong(String path, String expected, JsonNode got) {
        return new FieldException(false, path, "expected " + expected + ", got " + Place.shown(got.toString()));
    }
}
