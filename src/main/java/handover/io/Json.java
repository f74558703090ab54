package handover.io;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.Scene;
import handover.math.Vector3;

/** JSON trees for logs and messages: fields in the order in which they were put, doubles that read back exactly. */
final class Json {
    /** The fast writer prints the shortest digits on every Java version, so that logs are the same. */
    private static final JsonMapper MAPPER = JsonMapper.builder().enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER).build();

    private Json() {}

    static ObjectNode object() {
        return JsonNodeFactory.instance.objectNode();
    }

    /** A tree on one line, without line end. */
    static String line(JsonNode tree) {
        try {
            return MAPPER.writeValueAsString(tree);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException(e);
        }
    }

    static ArrayNode list(double[] values) {
        ArrayNode list = JsonNodeFactory.instance.arrayNode();
        for (double v : values) {
            list.add(v);
        }
        return list;
    }

    static ArrayNode list(Vector3 v) {
        return list(new double[] {v.x(), v.y(), v.z()});
    }

    static ArrayNode list(Iterable<String> values) {
        ArrayNode list = JsonNodeFactory.instance.arrayNode();
        values.forEach(list::add);
        return list;
    }

    /** A value for each object of a scene, by name. */
    static ObjectNode byObject(Scene scene, double[] values) {
        ObjectNode tree = object();
        for (int i = 0; i < values.length; i++) {
            tree.put(scene.objects().get(i).name(), values[i]);
        }
        return tree;
    }

    /** The objects of a scene in the form of a domain file. */
    static ArrayNode scene(Scene scene) {
        ArrayNode list = JsonNodeFactory.instance.arrayNode();
        scene.objects().forEach(o -> list.add(RecordMapper.tree(o)));
        return list;
    }
}
