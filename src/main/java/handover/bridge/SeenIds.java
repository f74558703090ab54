package handover.bridge;

import handover.io.WireMessage;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * The ids of the messages that were applied, by source: the last {@value #IDS} of each of the {@value #SOURCES} sources that
 * were heard last. Used by one thread.
 */
final class SeenIds {
    static final int SOURCES = 256;
    static final int IDS = 1024;

    private final Map<String, Set<String>> bySource = new LinkedHashMap<>(16, 0.75f, true);

    /** Whether a message with this id and source was applied; never true of one without id. */
    boolean contains(WireMessage.Envelope envelope) {
        return envelope.id() != null && bySource.getOrDefault(envelope.source(), Collections.emptySet()).contains(envelope.id());
    }

    void add(WireMessage.Envelope envelope) {
        if (envelope.id() == null) {
            return;
        }
        Set<String> ids = bySource.computeIfAbsent(envelope.source(), s -> new LinkedHashSet<>());
        if (ids.add(envelope.id()) && ids.size() > IDS) {
            ids.remove(ids.iterator().next());
        }
        if (bySource.size() > SOURCES) {
            bySource.remove(bySource.keySet().iterator().next());
        }
    }
}
