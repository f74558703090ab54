package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.Observation;
import handover.simulation.Arrival;
import handover.simulation.TimedStep;
import java.util.ArrayList;
import java.util.List;

/** When a step happened, as a JSON object. What was said and shown is in the step; here is when. Times are in seconds. */
final class TimeJson {
    private TimeJson() {}

    static ObjectNode tree(TimedStep t) {
        ObjectNode tree = Json.object().put("start", t.start()).put("end", t.end()).put("planned_at", t.plannedAt())
                .put("planned_for", t.plannedFor()).put("version", t.version()).put("differs", t.differs()).put("plannings", t.plannings());
        for (Arrival a : t.arrivals()) {
            String what = a.speech() == null ? "gesture" : "speech";
            tree.put(what + "_at", a.at()).put(what + "_arrives", a.arrives());
        }
        return tree;
    }

    /**
     * @param o what was sensed in the step
     * @param before when the act before it was over
     * @throws FieldException for what is not when it happened
     */
    static TimedStep step(Fields f, Observation o, double before) {
        double start = notBefore(before, f, "start");
        List<Arrival> arrivals = new ArrayList<>();
        if (o.speech() != null) {
            double at = notBefore(start, f, "speech_at");
            arrivals.add(new Arrival(at, notBefore(at, f, "speech_arrives"), o.speech(), null));
        }
        if (o.gesture() != null) {
            double at = notBefore(start, f, "gesture_at");
            arrivals.add(new Arrival(at, notBefore(at, f, "gesture_arrives"), null, o.gesture()));
        }
        return new TimedStep(start, notBefore(start, f, "end"), f.number("planned_at"), f.whole("planned_for", 0, Long.MAX_VALUE),
                f.whole("version", 0, Long.MAX_VALUE), f.flag("differs"), (int) f.whole("plannings", 0, Integer.MAX_VALUE), arrivals);
    }

    private static double notBefore(double earliest, Fields f, String key) {
        double t = f.number(key);
        if (t < earliest) {
            throw f.wrong(key, "a time of at least " + earliest + " s");
        }
        return t;
    }
}
