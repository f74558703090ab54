package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Task;
import handover.solver.Decision;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/** What is answered, as JSON on one line without line end (PROTOCOL.md). */
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
    }

    /** @param re id of the message that is answered, null if it has none */
    public static String belief(String re, HandoverBelief belief, Remarks remarks) {
        ObjectNode tree = beliefs("belief", re, belief);
        if (remarks.uninformative) {
            tree.put("uninformative", true);
        }
        if (!remarks.unknownWords.isEmpty()) {
            tree.set("unknown_words", Json.list(remarks.unknownWords));
        }
        if (!remarks.complete) {
            tree.put("final", false);
        }
        return Json.line(tree);
    }

    /** Everything about the belief and the task. */
    public static String state(String re, HandoverBelief belief) {
        return Json.line(withTask(beliefs("state", re, belief), belief.task()));
    }

    /** The end of an episode. */
    public static String summary(String re, HandoverBelief belief, int acts) {
        return Json.line(withTask(beliefs("summary", re, belief), belief.task()).put("acts", acts));
    }

    public static String error(WireException e) {
        ObjectNode tree = envelope("error", e.re());
        tree.put("code", e.code().key()).put("path", e.path()).put("message", e.getMessage());
        return Json.line(tree);
    }

    /**
     * A decision and why; the values of the acts from the best to the worst.
     *
     * @param belief at which it was made
     * @param milliseconds that it took
     */
    public static String decision(HandoverBelief belief, Decision decision, double milliseconds) {
        ObjectNode tree = envelope("decision", null);
        tree.setAll(act(decision.act()));
        ActModel model = belief.scene().model(decision.act());
        if (model != null && !model.say().isEmpty()) {
            tree.put("say", model.say());
        }
        tree.set("belief", Json.byObject(belief.scene(), belief.probabilities()));
        tree.set("human_belief", Json.byObject(belief.scene(), belief.human()));
        ObjectNode values = tree.putObject("values");
        decision.values().entrySet().stream().sorted(Map.Entry.comparingByValue(Comparator.reverseOrder()))
                .forEach(v -> values.put(v.getKey().toString(), v.getValue()));
        tree.put("depth", decision.depth()).put("nodes", decision.nodes()).put("ms", milliseconds)
                .put("finished", decision.finished());
        if (!decision.note().isEmpty()) {
            tree.put("note", decision.note());
        }
        return Json.line(tree);
    }

    private static ObjectNode beliefs(String type, String re, HandoverBelief belief) {
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

    private static ObjectNode envelope(String type, String re) {
        ObjectNode tree = Json.object().put("v", 1).put("type", type);
        return re == null ? tree : tree.put("re", re);
    }

    private static ObjectNode act(Act act) {
        ObjectNode tree = Json.object().put("act", act.verb());
        tree.set("objects", Json.list(act.objects()));
        return tree;
    }
}
