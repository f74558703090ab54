package handover.bridge;

import handover.io.Events;
import java.util.LinkedHashMap;
import java.util.Map;

/** What a bridge counts and measures of itself. Used by one thread. */
final class Vitals {
    private final double started;
    private final Map<String, Long> counters = new LinkedHashMap<>();
    private final Sources sources = new Sources();
    private final Latencies applying = new Latencies();
    private final Latencies deciding = new Latencies();
    private final Latencies late = new Latencies();

    /** @param started Unix seconds */
    Vitals(double started) {
        this.started = started;
    }

    void count(String name) {
        counters.merge(name, 1L, Long::sum);
    }

    /** So many messages gave way so far. */
    void shed(long messages) {
        if (messages > 0) {
            counters.put("shed", messages);
        }
    }

    Map<String, Long> counters() {
        return counters;
    }

    Sources sources() {
        return sources;
    }

    /** A message was taken from its socket so many nanoseconds before the belief after it was published. */
    void applied(long nanos) {
        applying.add(nanos);
    }

    /** A decision was answered after so many nanoseconds, with so many to its deadline. */
    void decided(long nanos, long limit) {
        deciding.add(nanos);
        late.add(Math.max(0, nanos - limit));
    }

    /**
     * The event that is published every second.
     *
     * @param waiting messages of the stream, and how many bytes they are
     */
    String heartbeat(double now, Snapshot at, long waiting, long bytes) {
        Map<String, Long> queues = new LinkedHashMap<>();
        queues.put("stream", waiting);
        queues.put("stream_bytes", bytes);
        Map<String, double[]> latencies = new LinkedHashMap<>();
        latencies.put("apply", applying.quantiles(0.5, 0.99));
        latencies.put("decide", deciding.quantiles(0.5, 0.99));
        latencies.put("decide_late", late.quantiles(0.5, 0.99));
        return Events.heartbeat(now, now - started, at.version(), at.episode(), queues, counters, sources.lastSeen(), latencies);
    }
}
