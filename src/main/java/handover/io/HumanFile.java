package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.GestureParameters;
import handover.domain.InvalidParameterException;
import handover.domain.PerceptionParameters;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.Understanding;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What a human file may say: how people differ from what the planner believes of them. Fields are those of
 * {@link DomainSpec}.
 *
 * @param objects only those for which these people have words of their own
 * @param acts verb in lower case to how these people reply to that type of act
 */
record HumanFile(String description, double tau, double tauHuman, Understanding understanding,
        PerceptionParameters perception, SpeechParameters speech, GestureParameters gesture, Vector3 shoulder, List<NamedWords> objects, Map<String, Replies> acts) {
    private static final Shape SHAPE = new Shape("a human file");

    /** The words that these people use for an object of the domain. */
    record NamedWords(String name, Map<String, Double> words) {
        TableObject over(TableObject o, Place at) {
            try {
                return new TableObject(o.name(), o.position(), words, o.label());
            } catch (InvalidParameterException e) {
                throw at.invalid(e);
            }
        }
    }

    /** Fields of {@link ActParameters} that are about the human. */
    record Replies(double speechRate, double gestureRate, double answerIfMatch, double answerIfMiss) {
        static Replies of(ActParameters p) {
            return new Replies(p.speechRate(), p.gestureRate(), p.answerIfMatch(), p.answerIfMiss());
        }

        ActParameters over(ActParameters p) {
            return new ActParameters(p.reward(), p.duration(), speechRate, gestureRate, answerIfMatch, answerIfMiss);
        }
    }

    /** The planner's view of people with what a file says instead. */
    static HumanFile read(DomainSpec planner, JsonNode json, Place file) {
        ObjectNode user = Shape.root(json, file);
        user.path("acts").fieldNames().forEachRemaining(verb -> {
            if (!planner.acts().containsKey(verb)) {
                throw SHAPE.unknown(file.key("acts").key(verb), verb, planner.acts().keySet());
            }
        });
        ObjectNode whole = Overlay.merge(RecordMapper.tree(of(planner)), user);
        SHAPE.check(whole, HumanFile.class, file);
        return RecordMapper.bind(whole, HumanFile.class, file);
    }

    /** People as the planner takes them to be. */
    static HumanFile of(DomainSpec planner) {
        Map<String, Replies> acts = new LinkedHashMap<>();
        planner.acts().forEach((verb, parameters) -> acts.put(verb, Replies.of(parameters)));
        return new HumanFile(planner.description(), planner.tau(), planner.tauHuman(), planner.understanding(),
                planner.perception(), planner.speech(), planner.gesture(), planner.shoulder(), List.of(), acts);
    }

    /** The planner's domain with these people in it; throws {@link DomainFileException} for what it refuses. */
    DomainSpec over(DomainSpec planner, Place file) {
        List<TableObject> table = inTheirWords(planner.objects(), file.key("objects"));
        Map<String, ActParameters> replies = new LinkedHashMap<>();
        planner.acts().forEach((verb, parameters) -> replies.put(verb, overAct(verb, parameters, file)));
        try {
            return planner.with(f -> {
                f.description = description;
                f.tau = tau;
                f.tauHuman = tauHuman;
                f.understanding = understanding;
                f.perception = perception;
                f.speech = speech;
                f.gesture = gesture;
                f.shoulder = shoulder;
                f.objects = table;
                f.acts = replies;
            });
        } catch (InvalidParameterException e) {
            boolean inDomain = e.field().startsWith("objects");
            throw inDomain ? file.error("with these people in the domain: " + e.getMessage(), e) : file.invalid(e);
        }
    }

    private List<TableObject> inTheirWords(List<TableObject> table, Place list) {
        List<TableObject> result = new ArrayList<>(table);
        List<String> names = table.stream().map(TableObject::name).toList();
        Set<String> seen = new HashSet<>();
        for (int i = 0; i < objects.size(); i++) {
            NamedWords o = objects.get(i);
            Place name = list.at(i).key("name");
            if (!names.contains(o.name)) {
                throw name.error("expected the name of an object, one of " + String.join(", ", names) + ", got \""
                        + o.name + "\"");
            } else if (!seen.add(o.name)) {
                throw name.error("expected each object once, got \"" + o.name + "\" again");
            }
            int k = names.indexOf(o.name);
            result.set(k, o.over(table.get(k), list.at(i)));
        }
        return result;
    }

    private ActParameters overAct(String verb, ActParameters planned, Place file) {
        try {
            return acts.get(verb).over(planned);
        } catch (InvalidParameterException e) {
            throw file.key("acts").key(verb).invalid(e);
        }
    }
}
