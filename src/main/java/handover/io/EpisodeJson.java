package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.Act;
import handover.domain.TableObject;
import handover.domain.Vocabulary;
import handover.simulation.Episode;
import handover.simulation.Measures;
import handover.simulation.Step;
import handover.simulation.TimedEpisode;
import handover.simulation.TimedStep;
import java.util.ArrayList;
import java.util.List;

/** Episodes as JSON trees and back. */
final class EpisodeJson {
    private EpisodeJson() {}

    static ObjectNode tree(Episode e) {
        ObjectNode tree = Json.object().put("episode", e.index()).put("solver", e.solver()).put("wanted", e.wanted());
        ArrayNode steps = tree.putArray("steps");
        e.steps().forEach(s -> steps.add(tree(s)));
        tree.set("measures", tree(e.measures()));
        return tree;
    }

    /** With times, and the agent that decided. */
    static ObjectNode tree(TimedEpisode e, String agent) {
        ObjectNode tree = tree(e.episode()).put("agent", agent);
        for (int k = 0; k < e.times().size(); k++) {
            ((ObjectNode) tree.get("steps").get(k)).set("time", TimeJson.tree(e.times().get(k)));
        }
        return tree;
    }

    private static ObjectNode tree(Step s) {
        ObjectNode tree = Json.object().put("act", s.act().verb());
        tree.set("objects", Json.list(s.act().objects()));
        ObservationJson.put(s.observation(), tree);
        tree.put("reward", s.reward());
        tree.set("on_table", Json.list(s.belief().scene().objects().stream().map(TableObject::name).toList()));
        tree.set("belief", Json.list(s.belief().probabilities()));
        tree.set("human_belief", Json.list(s.belief().human()));
        return tree;
    }

    private static ObjectNode tree(Measures m) {
        return Json.object().put("success", m.success()).put("handed_over", m.handedOver()).put("seconds", m.seconds())
                .put("steps", m.steps()).put("return", m.discountedReturn()).put("questions", m.questions())
                .put("log_score", m.logScore()).put("brier_score", m.brierScore()).put("distance", m.distance());
    }

    /**
     * @param timed whether it has times
     * @throws FieldException for what is not an episode
     */
    static LoggedEpisode episode(JsonNode tree, Vocabulary vocabulary, boolean timed) {
        Fields f = new Fields(tree, "");
        List<LoggedEpisode.Step> steps = new ArrayList<>();
        List<TimedStep> times = new ArrayList<>();
        for (Fields s : f.objects("steps")) {
            LoggedEpisode.Step step = step(s, vocabulary);
            if (timed) {
                double before = times.isEmpty() ? 0 : times.get(times.size() - 1).end();
                times.add(TimeJson.step(s.object("time"), step.observation(), before));
            }
            steps.add(step);
        }
        return new LoggedEpisode((int) f.whole("episode", 0, Integer.MAX_VALUE), f.text("solver"), timed ? f.text("agent") : null,
                f.text("wanted"), List.copyOf(steps), List.copyOf(times), measures(f.object("measures")));
    }

    private static LoggedEpisode.Step step(Fields f, Vocabulary vocabulary) {
        List<String> onTable = List.copyOf(f.texts("on_table"));
        return new LoggedEpisode.Step(new Act(f.text("act"), f.texts("objects")),
                ObservationJson.observation(f, vocabulary), f.number("reward"), onTable,
                oneEach(f, "belief", onTable), oneEach(f, "human_belief", onTable));
    }

    private static double[] oneEach(Fields f, String key, List<String> onTable) {
        double[] p = f.numbers(key);
        if (p.length != onTable.size()) {
            throw f.wrong(key, "one number for each of the " + onTable.size() + " objects on the table");
        }
        return p;
    }

    private static Measures measures(Fields f) {
        return new Measures(f.flag("success"), f.flag("handed_over"), f.number("seconds"),
                (int) f.whole("steps", 0, Integer.MAX_VALUE), f.number("return"),
                (int) f.whole("questions", 0, Integer.MAX_VALUE), f.number("log_score"), f.number("brier_score"),
                f.number("distance"));
    }
}
