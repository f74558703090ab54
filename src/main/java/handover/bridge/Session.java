package handover.bridge;

import handover.belief.BeliefTracker;
import handover.belief.HandoverBelief;
import handover.belief.Timeline;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.InvalidParameterException;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.io.ObjectProbabilities;
import handover.io.Replies;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Simplex;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Applies messages to a belief in the order in which they come. A message that cannot be used changes nothing. What comes of
 * a sequence of messages follows from the messages and the times at which they came and were applied alone. Used by one thread.
 */
public final class Session {
    /** When a message comes of which it is not known when it came: its {@code t} is then not looked at. */
    public static final double TIMELESS = Double.NaN;

    /** Beliefs that differ by less did not move. */
    private static final double ROUNDING = 1e-9;

    private final HandoverDomain domain;
    private final double maxAge;
    private final SeenIds seen = new SeenIds();
    private Stage now;
    private double latest = Double.NEGATIVE_INFINITY;

    /**
     * Everything that a message may change.
     *
     * @param timeline null between {@code end} and {@code begin}
     * @param table what is on the table as far as anybody said, with what was handed over since
     */
    private record Stage(Timeline timeline, Scene table, Snapshot snapshot) {
        Stage to(Timeline next) {
            return new Stage(next, table, snapshot.with(next.now().now()));
        }
    }

    /**
     * What came of a message.
     *
     * @param after what is believed now
     * @param remarks what came with the message beside the belief
     * @param applied false if nothing changed: a repeated id, speech that is not final, a question about the state
     */
    public record Outcome(Snapshot after, Replies.Remarks remarks, boolean applied) {}

    /** Told of a message that is about to be applied; what it throws keeps the message from being applied. */
    @FunctionalInterface
    public interface Journal {
        /** Nobody is told. */
        Journal NONE = outcome -> { };

        void applying(Outcome outcome);
    }

    private Session(HandoverDomain domain, double maxAge, Stage now) {
        this.domain = domain;
        this.maxAge = maxAge;
        this.now = now;
    }

    /**
     * A session without an episode: it starts with {@code begin}.
     *
     * @param maxAge seconds after which what was sensed is not used any more
     */
    public static Session of(HandoverDomain domain, long seed, double maxAge) {
        return new Session(domain, maxAge, new Stage(null, domain.start(),
                new Snapshot(0, 0, seed, HandoverBelief.initial(domain), false, 0)));
    }

    /** A session in which an episode has begun and nobody knows what time it is. */
    public static Session begun(HandoverDomain domain) {
        HandoverBelief start = HandoverBelief.initial(domain);
        return new Session(domain, 0, new Stage(Timeline.of(BeliefTracker.of(start), TIMELESS), domain.start(),
                new Snapshot(0, 1, 0, start, true, 0)));
    }

    /** What is believed now; of an episode that has ended, what was believed last. */
    public Snapshot now() {
        return now.snapshot;
    }

    /** What is on the table as far as anybody said, with what was handed over since. */
    public Scene table() {
        return now.table;
    }

    /** What is believed in the episode that is under way. Throws {@link WireException} if there is none. */
    public Snapshot episode() {
        timeline();
        return now.snapshot;
    }

    /** Applies a message that did not have to wait. */
    public Outcome apply(WireMessage message, double arrival, Journal journal) {
        return apply(message, arrival, arrival, journal);
    }

    /**
     * Applies a message that moves the belief or asks for it.
     *
     * @param received when it came, Unix seconds; or {@link #TIMELESS}
     * @param applied when its turn came, likewise; earlier than {@code received} only if the clock was set back meanwhile
     * @throws WireException if it cannot be used
     */
    public Outcome apply(WireMessage message, double received, double applied, Journal journal) {
        WireMessage.Envelope envelope = message.envelope();
        if (message instanceof WireMessage.State) {
            return new Outcome(episode(), Replies.Remarks.NONE, false);
        } else if (message instanceof WireMessage.Heard heard && !heard.complete()) {
            return new Outcome(episode(), new Replies.Remarks(false, unknown(heard.speech(domain.vocabulary())), false), false);
        } else if (seen.contains(message)) {
            return new Outcome(now.snapshot, Replies.Remarks.NONE, false);
        }
        Moment moment = moment(envelope, Math.min(received, applied));
        Stage before = applied < latest && now.timeline != null
                ? new Stage(now.timeline.timeless(), now.table, now.snapshot) : now;
        Stage after = stage(message, before, moment);
        Outcome outcome = new Outcome(after.snapshot, remarks(message, before.snapshot, after.snapshot), true);
        journal.applying(outcome);
        now = after;
        latest = applied;
        seen.add(message);
        return outcome;
    }

    /**
     * When something happened and when that became known.
     *
     * @param t never later than {@code arrival}
     */
    private record Moment(double t, double arrival) {}

    private static Moment moment(WireMessage.Envelope envelope, double arrival) {
        return new Moment(envelope.t() == null || !(envelope.t() < arrival) ? arrival : envelope.t(), arrival);
    }

    private Timeline timeline() {
        if (now.timeline == null) {
            throw new WireException(WireCode.NO_EPISODE, "", now.snapshot.episode() == 0 ? "no episode has begun; expected begin"
                    : "the episode has ended; expected begin");
        }
        return now.timeline;
    }

    private Stage stage(WireMessage message, Stage before, Moment at) {
        if (message instanceof WireMessage.Begin begin) {
            return begin(begin, before, at);
        } else if (message instanceof WireMessage.SceneChange change) {
            return change(change, before, at);
        }
        timeline();
        if (message instanceof WireMessage.Acted acted) {
            Stage after = before.to(before.timeline.acted(at.t, ActedMessage.change(acted, before.timeline.now()), maxAge));
            boolean completed = acted.status() == WireMessage.Status.COMPLETED;
            return new Stage(after.timeline, after.table, completed ? after.snapshot.afterAct() : after.snapshot);
        } else if (message instanceof WireMessage.Heard heard) {
            Speech speech = heard.speech(domain.vocabulary());
            return sensed(t -> t.heard(speech), before, at);
        } else if (message instanceof WireMessage.Pointed pointed) {
            Gesture gesture = Arms.gesture(pointed, before.timeline.now().now().scene());
            return sensed(t -> t.saw(gesture), before, at);
        } else if (message instanceof WireMessage.End) {
            return new Stage(null, before.table, before.snapshot.ended());
        }
        throw new WireException(WireCode.BAD_TYPE, "type", "this is answered by the bridge's command socket only");
    }

    private Stage begin(WireMessage.Begin message, Stage before, Moment at) {
        Scene scene = before.table;
        double[] b = message.prior().isEmpty() ? domain.prior(scene) : ObjectProbabilities.of(message.prior(), scene, "prior");
        HandoverBelief start = HandoverBelief.of(domain.task(scene), b, Simplex.uniform(scene.size()));
        return new Stage(Timeline.of(BeliefTracker.of(start), at.t), scene, before.snapshot.begun(start, message.seed()));
    }

    private Stage change(WireMessage.SceneChange message, Stage before, Moment at) {
        Scene there = before.timeline == null ? before.table : before.timeline.now().now().scene();
        Scene table = Table.after(Frames.toTable(message, domain.spec()), before.table, there);
        if (before.timeline == null) {
            return new Stage(null, table, before.snapshot.with(before.snapshot.belief()));
        }
        Scene left = Table.left(there, message, table);
        if (left.size() == 0) {
            throw new WireException(WireCode.BAD_FIELD, "removed", "expected at least one object that stays");
        }
        Stage after = before.to(before.timeline.acted(at.t, t -> t.on(left), maxAge));
        return new Stage(after.timeline, table, after.snapshot);
    }

    private Stage sensed(UnaryOperator<BeliefTracker> change, Stage before, Moment at) {
        try {
            return before.to(before.timeline.sensed(at.t, at.arrival, change, maxAge));
        } catch (Timeline.StaleException e) {
            throw new WireException(WireCode.STALE, "t", "this was sensed " + Math.round(1000 * (at.arrival - at.t))
                    + " ms ago; expected at most " + Math.round(1000 * maxAge)
                    + " ms, and in an episode and step that are still known");
        } catch (InvalidParameterException e) {
            throw new WireException(WireCode.BAD_FIELD, e.field(), e.problem());
        }
    }

    private Replies.Remarks remarks(WireMessage message, Snapshot before, Snapshot after) {
        boolean sensed = message instanceof WireMessage.Heard || message instanceof WireMessage.Pointed;
        List<String> unknown = message instanceof WireMessage.Heard heard ? unknown(heard.speech(domain.vocabulary())) : List.of();
        boolean nothing = sensed && after.belief().uninformative()
                && Simplex.l1(before.belief().probabilities(), after.belief().probabilities()) < ROUNDING;
        return new Replies.Remarks(nothing, unknown, true);
    }

    private static List<String> unknown(Speech speech) {
        return speech.alternatives().stream().flatMap(a -> a.utterance().unknown().stream()).distinct().toList();
    }
}
