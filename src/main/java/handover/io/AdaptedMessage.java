package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.Adapter;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;

/**
 * What another publisher says, as a message of docs/bridge.md: the payload is under {@code message} (or is the whole), the time
 * under {@code originatingTime} (ISO 8601, .NET ticks or Unix seconds).
 */
public final class AdaptedMessage {
    private static final String TIME = "originatingTime";
    private static final double LEAST_TICKS = 1e17;
    private static final double TICKS_TO_1970 = 621_355_968_000_000_000.0;
    private static final double TICKS = 1e7;

    private AdaptedMessage() {}

    /**
     * The message, to be decoded like any other.
     *
     * @param topic under which it was published; becomes the source
     * @throws WireException for what is not JSON or has no such time
     */
    public static byte[] of(Adapter adapter, String topic, byte[] published) {
        JsonNode whole = Messages.parse(published);
        JsonNode payload = whole.has("message") ? whole.get("message") : whole;
        ObjectNode message = Json.object().put("v", Messages.VERSION)
                .put("type", RecordMapper.name(adapter.type())).put("source", topic);
        if (whole.hasNonNull(TIME)) {
            message.put("t", time(whole.get(TIME)));
        }
        if (!adapter.fields().isEmpty()) {
            adapter.fields().forEach((field, path) -> put(message, field, at(payload, path)));
        } else if (payload.isTextual() && adapter.type() == Adapter.Type.SPEECH) {
            message.set("text", payload);
        } else {
            payload.properties().forEach(e -> put(message, e.getKey(), message.has(e.getKey()) ? null : e.getValue()));
        }
        adapter.values().forEach((field, value) -> {
            if (value.equals("true") || value.equals("false")) {
                message.put(field, value.equals("true"));
            } else {
                message.put(field, value);
            }
        });
        return Json.line(message).getBytes(StandardCharsets.UTF_8);
    }

    private static void put(ObjectNode message, String field, JsonNode value) {
        if (value != null && !value.isMissingNode()) {
            message.set(field, value);
        }
    }

    private static JsonNode at(JsonNode payload, String path) {
        JsonNode node = payload;
        for (String key : path.isEmpty() ? new String[0] : path.split("\\.")) {
            node = node.isArray() && key.matches("[0-9]{1,6}") ? node.path(Integer.parseInt(key)) : node.path(key);
        }
        return node;
    }

    private static double time(JsonNode value) {
        if (value.isNumber()) {
            double number = value.doubleValue();
            return number < LEAST_TICKS ? number : (number - TICKS_TO_1970) / TICKS;
        }
        try {
            Instant t = OffsetDateTime.parse(value.asText()).toInstant();
            return t.getEpochSecond() + t.getNano() / 1e9;
        } catch (DateTimeException e) {
            throw new WireException(WireCode.BAD_FIELD, TIME, "expected a time such as 2026-11-22T08:00:00.5Z, got "
                    + Place.shown(value.toString()));
        }
    }
}
