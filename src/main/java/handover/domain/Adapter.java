package handover.domain;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * How a topic that somebody else publishes is read as messages of a sensor. Immutable.
 *
 * @param type what the messages are
 * @param fields field of a message to where it is in what is published, keys joined by dots; empty if it has the same fields
 * @param values field of a message to what it always is, for instance the frame
 */
public record Adapter(Type type, Map<String, String> fields, Map<String, String> values) {
    /** What can be adapted. */
    public enum Type { SPEECH, GESTURE }

    /** Throws {@link InvalidParameterException}. */
    public Adapter {
        Check.present("type", type, "speech or gesture");
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("fields", fields, "an object")));
        values = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("values", values, "an object")));
    }
}
