package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Scene;
import handover.domain.Task;
import handover.solver.Decision;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/** What is answered, as JSON on one line without line end (docs/bridge.md). */
public final class Replies {
    private Replies() {}

    /**
     * What came with the last message beside the belief.
     *
     * @param uninformative whether it told nothing about any object
     * @param unknownWords that were heard
     * @param complete false if it was speech that the recogniser is not done with
     */
    public record Remarks(boolean uninformative, List<String> unknownWords, boolean complete) {
        public static final Remarks NONE = new Remarks(false, List.of(), true);

        /** Adds what is remarkable to a reply (modified). */
        ObjectNode put(ObjectNode reply) {
            if (uninformative) {
                reply.put("uninformative", true);
            }
            if (!unknownWords.isEmpty()) {
                reply.set("unknown_words", Json.list(unknownWords));
            }
            return complete ? reply : reply.put("final", false);
        }
    }

    /**
     * A message was applied.
     *
     * @param re id of the message that is answered, null if it has none
     * @param version of the belief after it
     */
    public static String ok(String re, long version, Remarks remarks) {
        return Json.line(remarks.put(envelope("ok", re).put("belief", version)));
    }

    /** A later {@code decide} came before this one was answered. */
    public static String superseded(String re) {
        return Json.line(envelope("superseded", re));
    }

    /** @param re id of the message that is answered, null if it has none */
    public static String belief(String re, HandoverBelief belief, Remarks remarks) {
        return Json.line(remarks.put(beliefs("belief", re, belief)));
    }

    /** Everything about the belief, the task and the table. */
    public static String state(String re, HandoverBelief belief) {
        return Json.line(stateTree(re, belief));
    }

    /**
     * The same of a running bridge.
     *
     * @param version of the belief
     * @param episode counts the episodes
     * @param counters of the bridge
     */
    public static String state(String re, HandoverBelief belief, long version, long episode, Map<String, Long> counters) {
        ObjectNode tree = stateTree(re, belief).put("belief_version", version).put("episode", episode);
        counters.forEach(tree.putObject("counters")::put);
        return Json.line(tree);
    }

    private static ObjectNode stateTree(String re, HandoverBelief belief) {
        ObjectNode tree = withTask(beliefs("state", re, belief), belief.task());
        tree.set("scene", Json.scene(belief.scene()));
        return tree;
    }

    /** The end of an episode. */
    public static String summary(String re, HandoverBelief belief, int acts) {
        return Json.line(summaryTree(re, belief, acts));
    }

    /** The same of a running bridge; {@code version} is that of the last belief. */
    public static String summary(String re, HandoverBelief belief, int acts, long version, long episode) {
        return Json.line(summaryTree(re, belief, acts).put("belief_version", version).put("episode", episode));
    }

    private static ObjectNode summaryTree(String re, HandoverBelief belief, int acts) {
        return withTask(beliefs("summary", re, belief), belief.task()).put("acts", acts);
    }

    public static String error(WireException e) {
        return Json.line(errorTree(e));
    }

    static ObjectNode errorTree(WireException e) {
        return envelope("error", e.re()).put("code", e.code().key()).put("path", e.path()).put("message", e.getMessage());
    }

    /**
     * A decision and why; the values of the acts from the best to the worst.
     *
     * @param belief at which it was made
     * @param milliseconds that it took
     */
    public static String decision(HandoverBelief belief, Decision decision, double milliseconds) {
        return Json.line(decisionTree(null, belief, belief.scene(), decision, milliseconds));
    }

    /**
     * The same of a running bridge.
     *
     * @param table where the objects are now
     * @param version of the belief at which it was made
     * @param fallback whether it is only what is always possible
     */
    public static String decision(String re, HandoverBelief belief, Scene table, Decision decision, double milliseconds,
            long version, boolean fallback) {
        return Json.line(decisionTree(re, belief, table, decision, milliseconds).put("belief_version", version)
                .put("fallback", fallback));
    }

    private static ObjectNode decisionTree(String re, HandoverBelief belief, Scene table, Decision decision, double milliseconds) {
        ObjectNode tree = envelope("decision", re);
        tree.setAll(act(decision.act()));
        ActModel model = belief.scene().model(decision.act());
        if (model != null && !model.say().isEmpty()) {
            tree.put("say", model.say());
        }
        int target = decision.act().objects().size() == 1 ? table.indexOf(decision.act().objects().get(0)) : -1;
        if (target >= 0) {
            tree.set("target", Json.list(table.objects().get(target).position()));
        }
        tree.set("belief", Json.byObject(belief.scene(), belief.probabilities()));
        tree.set("human_belief", Json.byObject(belief.scene(), belief.human()));
        ObjectNode values = tree.putObject("values");
        decision.values().entrySet().stream().sorted(Map.Entry.comparingByValue(Comparator.reverseOrder()))
                .forEach(v -> values.put(v.getKey().toString(), v.getValue()));
        tree.put("depth", decision.depth()).put("nodes", decision.nodes()).put("ms", milliseconds)
                .put("finished", decision.finished());
        if (decision.bounds() != null) {
            tree.putArray("bounds").add(decision.bounds().lower()).add(decision.bounds().upper());
        }
        if (!decision.note().isEmpty()) {
            tree.put("note", decision.note());
        }
        return tree;
    }

    /** The fields that tell an observer all about a belief. */
    static ObjectNode beliefs(String type, String re, HandoverBelief belief) {
        ObjectNode tree = envelope(type, re);
        tree.set("belief", Json.byObject(belief.scene(), belief.probabilities()));
        tree.set("human_belief", Json.byObject(belief.scene(), belief.human()));
        Act open = belief.task().openReference();
        tree.set("open_reference", open == null ? tree.nullNode() : act(open));
        tree.put("done", belief.task().done());
        return tree;
    }

    private static ObjectNode withTask(ObjectNode tree, Task task) {
        return tree.put("target", task.target()).put("progress", task.progress()).put("handovers", task.handovers());
    }

    static ObjectNode envelope(String type, String re) {
        ObjectNode tree = Json.object().put("v", 1).put("type", type);
        return re == null ? tree : tree.put("re", re);
    }

    static ObjectNode act(Act act) {
        ObjectNode tree = Json.object().put("act", act.verb());
        tree.set("objects", Json.list(act.objects()));
        return tree;
    }
}
