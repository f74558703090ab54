package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import java.util.Set;

/** Lays what a file says over what holds without it. */
final class Overlay {
    /** Distributions and vocabularies are given as a whole: a word less is meant to be a word less. */
    private static final Set<String> WHOLE = Set.of("prior", "words");

    private Overlay() {}

    /** A new tree: {@code base} with what {@code over} gives in its place, objects key by key. Neither is modified. */
    static ObjectNode merge(ObjectNode base, ObjectNode over) {
        ObjectNode merged = base.deepCopy();
        for (Map.Entry<String, JsonNode> e : over.properties()) {
            boolean byKey = merged.get(e.getKey()) instanceof ObjectNode && e.getValue().isObject()
                    && !WHOLE.contains(e.getKey());
            merged.set(e.getKey(), byKey ? merge((ObjectNode) merged.get(e.getKey()), (ObjectNode) e.getValue())
                    : e.getValue().deepCopy());
        }
        return merged;
    }
}
