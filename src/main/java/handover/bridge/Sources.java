package handover.bridge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** When each source was heard last: the {@value #MOST} that were heard last. Used by one thread. */
final class Sources {
    private static final int MOST = 256;

    private final Map<String, Double> seen = new LinkedHashMap<>(16, 0.75f, true);
    private final Map<String, Boolean> reported = new LinkedHashMap<>();

    /** A message of a source came; one without name is nobody's. */
    void seen(String source, double now) {
        if (!source.isEmpty()) {
            seen.put(source, now);
            reported.remove(source);
            if (seen.size() > MOST) {
                String oldest = seen.keySet().iterator().next();
                seen.remove(oldest);
                reported.remove(oldest);
            }
        }
    }

    /** The sources that have been silent for so many seconds, each once. */
    List<String> silent(double now, double timeout) {
        List<String> silent = new ArrayList<>();
        seen.forEach((source, t) -> {
            if (now - t > timeout && reported.put(source, true) == null) {
                silent.add(source);
            }
        });
        return silent;
    }

    /** When each was heard last, Unix seconds. */
    Map<String, Double> lastSeen() {
        return new LinkedHashMap<>(seen);
    }
}
