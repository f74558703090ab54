package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.math.Vector3;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Whether a JSON tree has the shape of a record: its keys, all of them, no others, each with the right kind of value.
 * Ranges are the record's own business.
 *
 * @param kind what messages call the file, for instance "a domain file"
 */
record Shape(String kind) {

    /** Throws {@link DomainFileException} for the first part of the tree that cannot be the given type. */
    void check(JsonNode node, Type type, Place at) {
        if (type instanceof ParameterizedType container) {
            checkContainer(node, container, at);
        } else {
            checkValue(node, (Class<?>) type, at);
        }
    }

    private void checkContainer(JsonNode node, ParameterizedType type, Place at) {
        Type[] arguments = type.getActualTypeArguments();
        Type content = arguments[arguments.length - 1];
        if (type.getRawType() == Map.class) {
            object(node, at).properties().forEach(e -> check(e.getValue(), content, at.key(e.getKey())));
            return;
        }
        require(node.isArray(), "a list [...]", node, at);
        for (int i = 0; i < node.size(); i++) {
            check(node.get(i), content, at.at(i));
        }
    }

    private void checkValue(JsonNode node, Class<?> type, Place at) {
        if (type.isEnum()) {
            List<String> names = names(type);
            require(node.isTextual() && names.contains(node.textValue()), "one of " + String.join(", ", names), node, at);
        } else if (type == Vector3.class) {
            require(node.isArray() && node.size() == 3, "[x, y, z] in metres", node, at);
            for (int k = 0; k < 3; k++) {
                require(finite(node.get(k)), "metres", node.get(k), at.at(k));
            }
        } else if (type.isRecord()) {
            checkRecord(object(node, at), type, at);
        } else if (type == int.class) {
            require(node.isIntegralNumber() && node.canConvertToInt(), "a whole number", node, at);
        } else if (type == String.class) {
            require(node.isTextual(), "text in double quotes", node, at);
        } else {
            require(finite(node), "a number", node, at);
        }
    }

    private void checkRecord(ObjectNode node, Class<?> type, Place at) {
        Map<String, Type> fields = fields(type);
        for (Map.Entry<String, JsonNode> e : node.properties()) {
            if (!fields.containsKey(e.getKey())) {
                throw unknown(at.key(e.getKey()), e.getKey(), fields.keySet());
            }
        }
        for (Map.Entry<String, Type> field : fields.entrySet()) {
            if (!node.has(field.getKey())) {
                throw at.key(field.getKey()).error("this key is missing");
            }
            check(node.get(field.getKey()), field.getValue(), at.key(field.getKey()));
        }
    }

    /** A key that nobody reads. */
    DomainFileException unknown(Place at, String key, Collection<String> known) {
        return at.error("unknown key" + NearestKey.suggestion(key, known) + "; this is " + kind
                + ", which may have here " + String.join(", ", known));
    }

    /** The keys of a file, without the one that tells an editor how to check it. */
    static ObjectNode root(JsonNode json, Place file) {
        ObjectNode root = object(json, file).deepCopy();
        root.remove("$schema");
        return root;
    }

    private static ObjectNode object(JsonNode node, Place at) {
        require(node.isObject(), "an object {...}", node, at);
        return (ObjectNode) node;
    }

    /** The keys under which a file has a record's fields, with their types. */
    static Map<String, Type> fields(Class<?> type) {
        Map<String, Type> fields = new LinkedHashMap<>();
        for (RecordComponent c : type.getRecordComponents()) {
            fields.put(RecordMapper.key(c.getName()), c.getGenericType());
        }
        return fields;
    }

    private static List<String> names(Class<?> type) {
        return Arrays.stream(type.getEnumConstants()).map(c -> RecordMapper.name((Enum<?>) c)).toList();
    }

    private static boolean finite(JsonNode node) {
        return node.isNumber() && Double.isFinite(node.doubleValue());
    }

    private static void require(boolean right, String expected, JsonNode got, Place at) {
        if (!right) {
            throw at.expected(expected, got);
        }
    }
}
