package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.PickSignal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Stream;

/** Bytes to {@link WireMessage}s, strictly; fields that are not known are let be. Thread safe. */
public final class Messages {
    /** A message may have so many bytes. */
    public static final int LARGEST = 1 << 20;

    static final int VERSION = 1;
    /** Later than this are milliseconds taken for seconds. */
    private static final double LATEST = 1e11;
    private static final double ROUNDING = 1e-6;
    private static final double LONGEST_DEADLINE = 3_600_000;
    /** An id or the name of a source may have so many characters. */
    private static final int LONGEST_NAME = 200;
    /** A transcript may have so many characters, and speech so many alternatives: what is longer would hold up a decision. */
    private static final int LONGEST_TRANSCRIPT = 2000;
    private static final int MOST_ALTERNATIVES = 100;
    private static final Map<String, BiFunction<WireMessage.Envelope, Fields, WireMessage>> TYPES = new LinkedHashMap<>();

    private static final Map<Class<? extends WireMessage>, String> NAMES = Map.of(
            WireMessage.Hello.class, "hello", WireMessage.Begin.class, "begin", WireMessage.Decide.class, "decide",
            WireMessage.Acted.class, "acted", WireMessage.Heard.class, "speech", WireMessage.Pointed.class, "gesture",
            WireMessage.SceneChange.class, "scene", WireMessage.State.class, "state", WireMessage.End.class, "end");

    static {
        TYPES.put("hello", (e, f) -> new WireMessage.Hello(e));
        TYPES.put("begin", (e, f) -> new WireMessage.Begin(e, prior(f),
                f.has("seed") ? f.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE) : null));
        TYPES.put("decide", (e, f) -> new WireMessage.Decide(e,
                f.has("deadline_ms") ? f.number("deadline_ms", 0, LONGEST_DEADLINE, "milliseconds") : null));
        TYPES.put("acted", Messages::acted);
        TYPES.put("speech", Messages::speech);
        TYPES.put("gesture", GestureFields::read);
        TYPES.put("scene", SceneFields::read);
        TYPES.put("state", (e, f) -> new WireMessage.State(e));
        TYPES.put("end", (e, f) -> new WireMessage.End(e));
    }

    private Messages() {}

    /**
     * Takes one message apart.
     *
     * @param bytes UTF-8, one JSON object
     * @throws WireException if they are anything else; it carries the message's id where that could be read
     */
    public static WireMessage decode(byte[] bytes) {
        return decode(parse(bytes));
    }

    /** The same of a tree. */
    static WireMessage decode(JsonNode tree) {
        if (!tree.isObject()) {
            throw new WireException(WireCode.NOT_JSON, "", "expected an object {...}, got " + Place.shown(tree.toString()));
        }
        String id = tree.path("id").textValue();
        try {
            return decode(new Fields(tree, ""));
        } catch (FieldException e) {
            WireCode code = e.missing() ? WireCode.MISSING_FIELD : WireCode.BAD_FIELD;
            throw new WireException(code, e.path(), e.getMessage()).about(id);
        } catch (WireException e) {
            throw e.about(id);
        }
    }

    /** How a message names its type. */
    static String type(WireMessage message) {
        return NAMES.get(message.getClass());
    }

    /** What is said of a message of more than {@link #LARGEST} bytes. */
    public static WireException tooLarge() {
        return new WireException(WireCode.TOO_LARGE, "", "expected at most 1 MiB");
    }

    /** Throws {@link WireException} for what is too large or not JSON. */
    static JsonNode parse(byte[] bytes) {
        if (bytes.length > LARGEST) {
            throw tooLarge();
        }
        try {
            return JsonText.parse(bytes, "message");
        } catch (DomainFileException e) {
            throw new WireException(e.path().isEmpty() ? WireCode.NOT_JSON : WireCode.BAD_FIELD, e.path(), e.problem());
        }
    }

    private static WireMessage decode(Fields f) {
        if (f.has("v") && !(f.node().get("v").isNumber() && f.node().get("v").doubleValue() == VERSION)) {
            throw new WireException(WireCode.BAD_VERSION, "v", f.wrong("v", Integer.toString(VERSION)).getMessage());
        }
        f.number("v");
        if (f.has("type") && !TYPES.containsKey(f.node().get("type").textValue())) {
            throw new WireException(WireCode.BAD_TYPE, "type",
                    f.wrong("type", "one of " + String.join(", ", TYPES.keySet())).getMessage());
        }
        String type = f.text("type");
        String source = name(f, "source");
        WireMessage.Envelope envelope = new WireMessage.Envelope(name(f, "id"), source == null ? "" : source,
                f.has("t") ? f.number("t", 0, LATEST, "Unix seconds") : null);
        return TYPES.get(type).apply(envelope, f);
    }

    /** A short text, or null if it is missing. */
    private static String name(Fields f, String key) {
        return f.has(key) ? atMost(LONGEST_NAME, f, key) : null;
    }

    private static String atMost(int longest, Fields f, String key) {
        String text = f.text(key);
        if (text.length() > longest) {
            throw f.wrong(key, "at most " + longest + " characters");
        }
        return text;
    }

    private static Map<String, Double> prior(Fields f) {
        if (!f.has("prior")) {
            return Map.of();
        }
        Map<String, Double> prior = f.probabilities("prior");
        double sum = prior.values().stream().mapToDouble(p -> p).sum();
        if (Math.abs(sum - 1) > ROUNDING) {
            throw new FieldException(false, "prior", "expected probabilities that sum to 1, got a sum of " + sum);
        }
        return prior;
    }

    private static WireMessage acted(WireMessage.Envelope envelope, Fields f) {
        List<String> statuses = Stream.of(WireMessage.Status.values()).map(RecordMapper::name).toList();
        WireMessage.Status status = WireMessage.Status.valueOf(upper(f.oneOf("status", statuses)));
        PickSignal pick = PickSignal.NONE;
        if (f.has("pick")) {
            pick = PickSignal.valueOf(upper(f.oneOf("pick", List.of("moving", "accepted", "rejected"))));
        }
        boolean decided = pick == PickSignal.ACCEPTED || pick == PickSignal.REJECTED;
        if (decided && status != WireMessage.Status.COMPLETED) {
            throw f.wrong("pick", "moving, because the act is not completed");
        }
        return new WireMessage.Acted(envelope, f.text("act"), f.has("objects") ? f.texts("objects") : List.of(), status, pick);
    }

    private static WireMessage speech(WireMessage.Envelope envelope, Fields f) {
        boolean complete = !f.has("final") || f.flag("final");
        if (!f.has("alternatives")) {
            return new WireMessage.Heard(envelope, List.of(new WireMessage.Reading(atMost(LONGEST_TRANSCRIPT, f, "text"), 1)), complete);
        }
        if (f.has("text")) {
            throw f.wrong("text", "either text or alternatives");
        }
        List<Fields> alternatives = f.objects("alternatives");
        if (alternatives.isEmpty() || alternatives.size() > MOST_ALTERNATIVES) {
            throw f.wrong("alternatives", "1 to " + MOST_ALTERNATIVES + " alternatives");
        }
        List<WireMessage.Reading> readings = alternatives.stream().map(a -> new WireMessage.Reading(
                atMost(LONGEST_TRANSCRIPT, a, "transcript"), a.number("confidence", 0, 1, "a confidence"))).toList();
        return new WireMessage.Heard(envelope, readings, complete);
    }

    private static String upper(String word) {
        return word.toUpperCase(Locale.ROOT);
    }
}
