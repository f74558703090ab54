package handover.bridge;

import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * The ids of the messages that were applied, by source, with a hash of what they said: the last {@value #IDS} of each of the {@value #SOURCES} sources that
 * were heard last. Used by one thread.
 */
final class SeenIds {
    static final int SOURCES = 256;
    static final int IDS = 1024;

    private final Map<String, Map<String, Integer>> bySource = new LinkedHashMap<>(16, 0.75f, true);

    /**
     * Whether this message was applied; never true of one without id.
     *
     * @throws WireException if another message with its id and source was
     */
    boolean contains(WireMessage message) {
        WireMessage.Envelope envelope = message.envelope();
        Integer applied = bySource.getOrDefault(envelope.source(), Map.of()).get(envelope.id() == null ? "" : envelope.id());
        if (envelope.id() == null || applied == null) {
            return false;
        } else if (applied != content(message)) {
            throw new WireException(WireCode.BAD_FIELD, "id", "another message with this id was applied; expected an id that is "
                    + "unique " + (envelope.source().isEmpty() ? "among all that give no source" : "to its source"));
        }
        return true;
    }

    void add(WireMessage message) {
        WireMessage.Envelope envelope = message.envelope();
        if (envelope.id() == null) {
            return;
        }
        Map<String, Integer> ids = bySource.computeIfAbsent(envelope.source(), s -> new LinkedHashMap<>());
        if (ids.put(envelope.id(), content(message)) == null && ids.size() > IDS) {
            ids.remove(ids.keySet().iterator().next());
        }
        if (bySource.size() > SOURCES) {
            bySource.remove(bySource.keySet().iterator().next());
        }
    }

    /** Not of when it was sensed: who sends it again may say so anew. */
    private static int content(WireMessage message) {
        if (message instanceof WireMessage.Heard heard) {
            return Objects.hash("speech", heard.alternatives());
        } else if (message instanceof WireMessage.Pointed pointed) {
            return Objects.hash("gesture", pointed.arms(), pointed.frame());
        } else if (message instanceof WireMessage.SceneChange change) {
            return Objects.hash("scene", change.moved(), change.removed(), change.added(), change.frame());
        } else if (message instanceof WireMessage.Acted acted) {
            return Objects.hash("acted", acted.act(), acted.objects(), acted.status(), acted.pick());
        } else if (message instanceof WireMessage.Begin begin) {
            return Objects.hash("begin", begin.prior(), begin.seed());
        }
        return message.getClass().hashCode();
    }
}
