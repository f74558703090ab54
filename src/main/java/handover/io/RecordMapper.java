package handover.io;

import com.fasterxml.jackson.annotation.JsonFormat;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.PropertyNamingStrategies;
import com.fasterxml.jackson.databind.cfg.JsonNodeFeature;
import com.fasterxml.jackson.databind.cfg.MapperConfig;
import com.fasterxml.jackson.databind.introspect.AnnotatedClass;
import com.fasterxml.jackson.databind.introspect.JacksonAnnotationIntrospector;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.InvalidParameterException;
import handover.math.Vector3;
import java.util.Arrays;
import java.util.Locale;

/** Records as JSON trees and back: keys in snake_case, enums in lower case, vectors as lists. Thread safe. */
final class RecordMapper {
    /** The fast writer prints the shortest digits on every Java version, which keeps {@link #canonical} the same. */
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .propertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE)
            .annotationIntrospector(new LowerCaseEnums())
            .withConfigOverride(Vector3.class,
                    o -> o.setFormat(JsonFormat.Value.forShape(JsonFormat.Shape.ARRAY)))
            .enable(JsonNodeFeature.WRITE_PROPERTIES_SORTED)
            .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
            .build();

    private RecordMapper() {}

    /** The key under which a file has a record's field. */
    static String key(String field) {
        return PropertyNamingStrategies.SnakeCaseStrategy.INSTANCE.translate(field);
    }

    /** How a file spells an enum's value. */
    static String name(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    static ObjectNode tree(Record data) {
        return MAPPER.valueToTree(data);
    }

    /** The same text for equal trees: keys sorted, no white space. */
    static String canonical(JsonNode tree) {
        try {
            return MAPPER.writeValueAsString(tree);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException(e);
        }
    }

    /** The record of a tree whose {@link Shape} was checked; throws {@link DomainFileException} for what it refuses. */
    static <T extends Record> T bind(JsonNode tree, Class<T> type, Place at) {
        try {
            return MAPPER.treeToValue(tree, type);
        } catch (JsonMappingException e) {
            if (e.getCause() instanceof InvalidParameterException invalid) {
                throw place(e, at).invalid(invalid);
            }
            throw new IllegalStateException("a checked tree must fit " + type, e);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a tree has no syntax", e);
        }
    }

    private static Place place(JsonMappingException e, Place at) {
        Place place = at;
        for (JsonMappingException.Reference step : e.getPath()) {
            place = step.getFieldName() == null ? place.at(step.getIndex()) : place.key(step.getFieldName());
        }
        return place;
    }

    private static final class LowerCaseEnums extends JacksonAnnotationIntrospector {
        private static final long serialVersionUID = 1L;

        @Override
        public String[] findEnumValues(MapperConfig<?> config, AnnotatedClass type, Enum<?>[] values, String[] names) {
            return Arrays.stream(values).map(RecordMapper::name).toArray(String[]::new);
        }
    }
}
