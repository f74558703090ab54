package handover.io;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.Gesture;
import handover.domain.InvalidParameterException;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.domain.Vocabulary;
import handover.math.Vector3;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * What was sensed in a step, as fields of a JSON object: {@code speech}, {@code gesture} and {@code signal}, where there are
 * any.
 */
final class ObservationJson {

    private ObservationJson() {}

    /** Adds an observation to a tree (modified). */
    static void put(Observation o, ObjectNode tree) {
        if (o.speech() != null) {
            ArrayNode speech = tree.putArray("speech");
            o.speech().alternatives().forEach(a -> speech.addObject().put("transcript", a.utterance().text())
                    .put("confidence", a.confidence()));
        }
        if (o.gesture() != null) {
            ObjectNode gesture = tree.putObject("gesture");
            gesture.set("shoulder", Json.list(o.gesture().shoulder()));
            gesture.set("direction", Json.list(o.gesture().direction()));
        }
        if (o.signal() != PickSignal.NONE) {
            tree.put("signal", RecordMapper.name(o.signal()));
        }
    }

    static Observation observation(Fields f, Vocabulary vocabulary) {
        List<String> signals = Stream.of(PickSignal.values()).map(RecordMapper::name).toList();
        String signal = f.has("signal") ? f.oneOf("signal", signals) : "none";
        return new Observation(f.has("speech") ? speech(f, vocabulary) : null,
                f.has("gesture") ? gesture(f.object("gesture")) : null,
                PickSignal.valueOf(signal.toUpperCase(Locale.ROOT)));
    }

    private static Speech speech(Fields f, Vocabulary vocabulary) {
        List<Speech.Alternative> alternatives = f.objects("speech").stream().map(a -> new Speech.Alternative(
                Utterance.parse(a.text("transcript"), vocabulary), a.number("confidence", 0, 1, "a confidence"))).toList();
        if (alternatives.isEmpty()) {
            throw f.wrong("speech", "at least one alternative");
        }
        return new Speech(alternatives);
    }

    private static Gesture gesture(Fields f) {
        Vector3 direction = f.vector("direction", "number");
        try {
            return new Gesture(f.vector("shoulder", "number of metres"), direction);
        } catch (InvalidParameterException e) {
            throw new FieldException(false, f.path() + "." + e.field(), e.problem());
        }
    }
}
