package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.belief.HandoverBelief;
import handover.domain.Scene;
import java.util.List;
import java.util.Map;

/** What is published, as JSON on one line without line end (docs/bridge.md, {@code events}). */
public final class Events {
    private Events() {}

    /**
     * What an event is about.
     *
     * @param cause the message that led to it; its id and source are named
     * @param t when it happened, Unix seconds
     * @param version of the belief
     * @param episode counts the episodes
     */
    public record Context(WireMessage.Envelope cause, double t, long version, long episode) {
        private ObjectNode put(ObjectNode tree) {
            if (!cause.source().isEmpty()) {
                tree.put("source", cause.source());
            }
            return tree.put("t", t).put("belief_version", version).put("episode", episode);
        }
    }

    /** What is believed now, and what was heard if speech was why. */
    public static String belief(Context context, HandoverBelief belief, WireMessage cause, Replies.Remarks remarks) {
        ObjectNode tree = context.put(Replies.beliefs("belief", context.cause.id(), belief));
        tree.put("cause", Messages.type(cause));
        if (cause instanceof WireMessage.Heard heard) {
            tree.set("heard", Json.list(heard.alternatives().stream().map(WireMessage.Reading::transcript).toList()));
        }
        return Json.line(remarks.put(tree));
    }

    /** What the robot did. */
    public static String act(Context context, WireMessage.Acted acted) {
        ObjectNode tree = context.put(Replies.envelope("act", context.cause.id())).put("act", acted.act());
        tree.set("objects", Json.list(acted.objects()));
        return Json.line(tree.put("status", RecordMapper.name(acted.status())).put("pick", RecordMapper.name(acted.pick())));
    }

    /** What is on the table now. */
    public static String scene(Context context, Scene scene) {
        ObjectNode tree = context.put(Replies.envelope("scene", context.cause.id()));
        tree.set("objects", Json.scene(scene));
        return Json.line(tree);
    }

    /** An episode began or ended. */
    public static String episode(Context context, boolean begun, List<String> objects) {
        ObjectNode tree = context.put(Replies.envelope("episode", context.cause.id())).put("event", begun ? "begin" : "end");
        tree.set("objects", Json.list(objects));
        return Json.line(tree);
    }

    /**
     * That the bridge lives, and how.
     *
     * @param uptime seconds
     * @param queues how much waits where
     * @param counters of what happened since the bridge started
     * @param sources when each was heard last, Unix seconds
     * @param latencies median and 99% quantile, milliseconds; empty for what never happened
     */
    public static String heartbeat(double t, double uptime, long version, long episode, Map<String, Long> queues,
            Map<String, Long> counters, Map<String, Double> sources, Map<String, double[]> latencies) {
        ObjectNode tree = Replies.envelope("heartbeat", null).put("t", t).put("uptime", uptime).put("belief_version", version)
                .put("episode", episode);
        queues.forEach(tree.putObject("queues")::put);
        counters.forEach(tree.putObject("counters")::put);
        ObjectNode seen = tree.putObject("sources");
        sources.forEach((source, last) -> seen.putObject(source).put("last_seen", last).put("silent", Math.max(0, t - last)));
        ObjectNode ms = tree.putObject("latency_ms");
        latencies.forEach((what, quantiles) -> {
            if (quantiles.length > 0) {
                ms.putObject(what).put("p50", quantiles[0]).put("p99", quantiles[1]);
            }
        });
        return Json.line(tree);
    }

    /** A source has not been heard for long. */
    public static String silent(String source, double lastSeen, double t) {
        return Json.line(Replies.envelope("silent", null).put("code", "silent").put("message", "nothing was sensed by "
                + source + " for " + Math.round(t - lastSeen) + " s").put("source", source).put("last_seen", lastSeen).put("t", t));
    }

    /** A message that could not be used. */
    public static String error(WireException e, String source, double t) {
        ObjectNode tree = Replies.errorTree(e).put("t", t);
        return Json.line(source.isEmpty() ? tree : tree.put("source", source));
    }
}
