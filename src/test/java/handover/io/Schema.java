package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SpecVersion;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;

/** A shipped JSON Schema: as an editor applies it, and as text that can be asked what it says about a key. */
final class Schema {
    private static final Path FOLDER = Path.of("domains", "schema");
    private static final JsonNode DOMAIN = text("domain");

    private final JsonSchema validator;
    private final JsonNode text;

    private Schema(String name) {
        SchemaLocation place = SchemaLocation.of(FOLDER.resolve(name + ".schema.json").toUri().toString());
        this.validator = JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(place);
        this.text = text(name);
    }

    /** {@code domain} or {@code human}. */
    static Schema of(String name) {
        return new Schema(name);
    }

    Set<ValidationMessage> faults(JsonNode file) {
        return validator.validate(file);
    }

    /** What it says about a key, given as in {@link #keys}. */
    JsonNode at(String path) {
        JsonNode node = text;
        for (String step : path.split("\\.")) {
            String key = step.replace("[]", "");
            JsonNode properties = resolved(node).path("properties");
            node = properties.has(key) ? properties.get(key) : resolved(node).path("additionalProperties");
            node = step.endsWith("[]") ? resolved(node).path("items") : node;
        }
        return resolved(node);
    }

    /**
     * All keys that it knows, as {@code speech.alpha} or {@code objects[].name}.
     *
     * @param example a whole file, for keys that the schema leaves to the user
     */
    Set<String> keys(JsonNode example) {
        Set<String> keys = new TreeSet<>();
        addKeys(text, example, "", keys);
        keys.remove("$schema");
        return keys;
    }

    private static void addKeys(JsonNode schema, JsonNode example, String prefix, Set<String> keys) {
        JsonNode here = resolved(schema);
        JsonNode others = resolved(here.path("additionalProperties"));
        Set<String> known = new TreeSet<>();
        here.path("properties").fieldNames().forEachRemaining(known::add);
        if (others.has("properties")) {
            example.fieldNames().forEachRemaining(known::add);
        }
        for (String key : known) {
            JsonNode value = here.path("properties").has(key) ? resolved(here.path("properties").get(key)) : others;
            keys.add(prefix + key);
            addKeys(value, example.path(key), prefix + key + ".", keys);
            addKeys(value.path("items"), example.path(key).path(0), prefix + key + "[].", keys);
        }
    }

    /** All keys of a file but words and names of objects, as in {@link #keys}. */
    static Set<String> keysOf(JsonNode file) {
        Set<String> keys = new TreeSet<>();
        addKeysOf(file, "", keys);
        return keys;
    }

    private static void addKeysOf(JsonNode node, String prefix, Set<String> keys) {
        node.properties().forEach(e -> {
            keys.add(prefix + e.getKey());
            if (!Set.of("words", "prior").contains(e.getKey())) {
                addKeysOf(e.getValue(), prefix + e.getKey() + ".", keys);
                addKeysOf(e.getValue().path(0), prefix + e.getKey() + "[].", keys);
            }
        });
    }

    /** All references are to definitions of the domain's schema. */
    private static JsonNode resolved(JsonNode node) {
        String reference = node.path("$ref").asText();
        if (reference.isEmpty()) {
            return node;
        }
        ObjectNode all = resolved(DOMAIN.at(reference.substring(reference.indexOf('#') + 1))).deepCopy();
        return all.setAll((ObjectNode) node);
    }

    private static JsonNode text(String name) {
        try {
            return JsonText.parse(Files.readAllBytes(FOLDER.resolve(name + ".schema.json")), name);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
