package handover.bridge;

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
import java.util.function.UnaryOperator;

/** What the robot says that it did, checked against what it can do. */
final class ActedMessage {
    private ActedMessage() {}

    /** What the robot did does to a tracker. Throws {@link WireException} if that cannot be done to this one. */
    static UnaryOperator<BeliefTracker> change(WireMessage.Acted message, BeliefTracker before) {
        Act act = act(message, before.now().scene());
        checkPick(message, act);
        switch (message.status()) {
            case STARTED -> {
                checkGoing(before);
                return t -> t.started(act);
            }
            case COMPLETED -> {
                checkOutcome(message, act, before);
                return t -> t.completed(act, message.pick());
            }
            default -> {
                return t -> t.abandoned(act);
            }
        }
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

    private static void checkGoing(BeliefTracker before) {
        if (before.now().task().done()) {
            throw new WireException(WireCode.ILLEGAL_ACT, "act", "the episode is over");
        }
    }

    private static void checkOutcome(WireMessage.Acted message, Act act, BeliefTracker before) {
        BeliefTracker under = before;
        if (!act.equals(before.act())) {
            checkGoing(before);
            under = before.started(act);
        }
        boolean decided = message.pick() == PickSignal.ACCEPTED || message.pick() == PickSignal.REJECTED;
        boolean stalls = message.pick() == PickSignal.NONE && under.stalled() != null;
        boolean pending = (stalls ? under.stalled() : under.now()).pickPending();
        if (pending && !decided) {
            throw new WireException(message.pick() == PickSignal.NONE ? WireCode.MISSING_FIELD : WireCode.BAD_FIELD, "pick",
                    "expected accepted or rejected, because this completes the pick");
        }
    }
}
