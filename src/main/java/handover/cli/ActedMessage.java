package handover.cli;

import handover.belief.BeliefTracker;
import handover.domain.Act;
import handover.domain.ActType;
import handover.domain.HandoverDomain;
import handover.domain.PickSignal;
import handover.domain.PickType;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** What the robot says that it did, checked against what it can do. */
final class ActedMessage {
    private ActedMessage() {}

    /** The tracker after what the robot did. Throws {@link WireException} if that cannot be. */
    static BeliefTracker apply(WireMessage.Acted message, BeliefTracker before) {
        Act act = act(message, before.now().scene());
        checkPick(message, act);
        return switch (message.status()) {
            case STARTED -> started(act, before);
            case COMPLETED -> completed(message, act, before);
            case FAILED, CANCELLED -> before.abandoned(act);
        };
    }

    private static Act act(WireMessage.Acted message, Scene scene) {
        HandoverDomain domain = scene.domain();
        List<String> verbs = domain.types().stream().map(ActType::verb).toList();
        if (!verbs.contains(message.act())) {
            throw new WireException(WireCode.ILLEGAL_ACT, "act", "expected one of " + String.join(", ", verbs)
                    + ", got \"" + message.act() + "\"");
        }
        List<String> names = new ArrayList<>(message.objects());
        for (int k = 0; k < names.size(); k++) {
            String path = "objects[" + k + "]";
            if (scene.indexOf(names.get(k)) < 0) {
                throw new WireException(WireCode.UNKNOWN_OBJECT, path, "expected an object that is on the table, one of "
                        + String.join(", ", scene.objects().stream().map(TableObject::name).toList())
                        + ", got \"" + names.get(k) + "\"");
            } else if (names.indexOf(names.get(k)) < k) {
                throw new WireException(WireCode.BAD_FIELD, path, "expected each object once, got " + names.get(k) + " again");
            }
        }
        names.sort(Comparator.comparing(scene::indexOf));
        Act act = new Act(message.act(), names);
        if (scene.model(act) == null) {
            throw new WireException(WireCode.ILLEGAL_ACT, "objects", act + " is not an act of this robot");
        }
        return act;
    }

    private static void checkPick(WireMessage.Acted message, Act act) {
        if (message.pick() != PickSignal.NONE && !act.verb().equals(PickType.VERB)) {
            throw new WireException(WireCode.BAD_FIELD, "pick", "expected this only with " + PickType.VERB + ", got it with "
                    + act.verb());
        }
    }

    private static BeliefTracker started(Act act, BeliefTracker before) {
        if (before.now().task().done()) {
            throw new WireException(WireCode.ILLEGAL_ACT, "act", "the episode is over");
        }
        return before.started(act);
    }

    private static BeliefTracker completed(WireMessage.Acted message, Act act, BeliefTracker before) {
        BeliefTracker under = act.equals(before.act()) ? before : started(act, before);
        boolean decided = message.pick() == PickSignal.ACCEPTED || message.pick() == PickSignal.REJECTED;
        boolean pending = message.pick() == PickSignal.NONE ? under.now().stalled().pickPending() : under.now().pickPending();
        if (pending && !decided) {
            throw new WireException(message.pick() == PickSignal.NONE ? WireCode.MISSING_FIELD : WireCode.BAD_FIELD, "pick",
                    "expected accepted or rejected, because this completes the pick");
        }
        return under.completed(act, message.pick());
    }
}
