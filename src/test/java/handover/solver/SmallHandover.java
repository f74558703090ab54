package handover.solver;

import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;

/** A handover small enough to be solved by enumeration: two objects, one word at a time, no gestures. */
final class SmallHandover {
    private SmallHandover() {}

    static DomainSpec spec() {
        List<TableObject> objects = List.of(
                new TableObject("cup", new Vector3(-0.3, 0.6, 0), Map.of("red", 1.0, "cup", 2.0), null),
                new TableObject("can", new Vector3(0.3, 0.6, 0), Map.of("red", 1.0, "can", 2.0), null));
        return DomainSpec.of("small", objects).with(s -> {
            s.acts.replaceAll((verb, a) -> new ActParameters(a.reward(), a.duration(), a.speechRate(), 0,
                    a.answerIfMatch(), a.answerIfMiss()));
            s.speech = new SpeechParameters(0.2, 0.05, 0, 0.2, 0.1, List.of(1.0));
        });
    }

    static HandoverDomain domain() {
        return new HandoverDomain(spec());
    }
}
