package handover.cli;

import handover.belief.BeliefTracker;
import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.domain.InvalidParameterException;
import handover.domain.Speech;
import handover.io.Messages;
import handover.io.ObjectProbabilities;
import handover.io.Replies;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Simplex;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Applies messages to a belief in the order in which they come, and answers each. A message that cannot be used changes
 * nothing. Used by one thread.
 */
final class Session {
    private static final int REMEMBERED = 100_000;
    private static final String TABLE = "table";

    private final HandoverDomain domain;
    /** What was applied, by source and id, oldest first. */
    private final Set<List<String>> applied = new LinkedHashSet<>();
    /** Null between {@code end} and {@code begin}. */
    private BeliefTracker tracker;
    /** What was believed when the last message had been applied. */
    private HandoverBelief last;
    private int acts;

    /** An episode begins at once. */
    Session(HandoverDomain domain) {
        this.domain = domain;
        this.last = HandoverBelief.initial(domain);
        this.tracker = BeliefTracker.of(last);
    }

    /** The reply to a message, on one line. */
    String answer(byte[] message) {
        String re = null;
        try {
            WireMessage decoded = Messages.decode(message);
            re = decoded.envelope().id();
            return answer(decoded, re);
        } catch (WireException e) {
            return Replies.error(re == null ? e : e.about(re));
        } catch (RuntimeException e) {
            return Replies.error(new WireException(WireCode.INTERNAL, "", e.toString()).about(re));
        }
    }

    private String answer(WireMessage message, String re) {
        List<String> key = re == null ? null : List.of(message.envelope().source(), re);
        if (key != null && applied.contains(key)) {
            return Replies.belief(re, last, Replies.Remarks.NONE);
        }
        String reply = apply(message, re);
        last = tracker == null ? last : tracker.now();
        remember(key);
        return reply;
    }

    private String apply(WireMessage message, String re) {
        if (message instanceof WireMessage.Begin begin) {
            return begin(begin, re);
        } else if (message instanceof WireMessage.Acted acted) {
            tracker = ActedMessage.apply(acted, episode());
            acts += acted.status() == WireMessage.Status.COMPLETED ? 1 : 0;
            return Replies.belief(re, tracker.now(), Replies.Remarks.NONE);
        } else if (message instanceof WireMessage.Heard heard) {
            return hear(heard, re);
        } else if (message instanceof WireMessage.Pointed pointed) {
            return see(pointed, re);
        } else if (message instanceof WireMessage.End) {
            HandoverBelief end = episode().now();
            tracker = null;
            return Replies.summary(re, end, acts);
        }
        return Replies.state(re, episode().now());
    }

    private BeliefTracker episode() {
        if (tracker == null) {
            throw new WireException(WireCode.NO_EPISODE, "", "the episode has ended; expected begin");
        }
        return tracker;
    }

    private String begin(WireMessage.Begin message, String re) {
        HandoverBelief start = HandoverBelief.initial(domain);
        if (!message.prior().isEmpty()) {
            start = HandoverBelief.of(start.task(), ObjectProbabilities.of(message.prior(), domain.start(), "prior"),
                    Simplex.uniform(domain.start().size()));
        }
        tracker = BeliefTracker.of(start);
        acts = 0;
        return Replies.belief(re, start, Replies.Remarks.NONE);
    }

    private String hear(WireMessage.Heard message, String re) {
        Speech speech = message.speech(domain.vocabulary());
        List<String> unknown = speech.alternatives().stream().flatMap(a -> a.utterance().unknown().stream()).distinct()
                .toList();
        if (message.complete()) {
            tracker = episode().heard(speech);
        }
        boolean uninformative = message.complete() && episode().now().uninformative();
        return Replies.belief(re, episode().now(), new Replies.Remarks(uninformative, unknown, message.complete()));
    }

    private String see(WireMessage.Pointed message, String re) {
        if (message.frame() != null && !message.frame().equals(TABLE)) {
            throw new WireException(WireCode.UNKNOWN_FRAME, "frame",
                    "expected the frame " + TABLE + ", got " + message.frame());
        }
        try {
            tracker = episode().saw(message.gesture());
        } catch (InvalidParameterException e) {
            throw new WireException(WireCode.BAD_FIELD, e.field(), e.problem());
        }
        return Replies.belief(re, tracker.now(), new Replies.Remarks(tracker.now().uninformative(), List.of(), true));
    }

    private void remember(List<String> key) {
        if (key != null && applied.add(key) && applied.size() > REMEMBERED) {
            applied.remove(applied.iterator().next());
        }
    }
}
