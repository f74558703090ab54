package handover.bridge;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Set;

/** Which topics somebody listens to. Used by one thread. */
final class Subscriptions {
    private final Set<String> prefixes = new HashSet<>();

    /** @param message of an XPUB socket: 1 or 0 and then the prefix that is wanted or not wanted any more */
    void change(byte[] message) {
        if (message.length == 0) {
            return;
        }
        String prefix = new String(message, 1, message.length - 1, StandardCharsets.UTF_8);
        if (message[0] == 1 && Topics.ALL.stream().anyMatch(t -> t.startsWith(prefix))) {
            prefixes.add(prefix);
        } else if (message[0] == 0) {
            prefixes.remove(prefix);
        }
    }

    boolean wants(String topic) {
        return prefixes.stream().anyMatch(topic::startsWith);
    }
}
