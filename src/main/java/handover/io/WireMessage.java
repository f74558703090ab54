package handover.io;

import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.domain.Vocabulary;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;

/**
 * A message of docs/bridge.md whose fields were checked as far as that is possible without knowing the domain: whether the
 * objects, the frame and the act exist is for the receiver to say. Immutable.
 */
public sealed interface WireMessage {
    Envelope envelope();

    /**
     * What every message may carry.
     *
     * @param id unique per source; null if none
     * @param source who sends; empty if not said
     * @param t when it was sensed, Unix seconds; null if not said
     */
    record Envelope(String id, String source, Double t) {}

    /** Who is there? */
    record Hello(Envelope envelope) implements WireMessage {}

    /**
     * Start an episode.
     *
     * @param prior object to probability, summing to one; empty for the domain's own
     * @param seed of the chance that decisions use; null if not said
     */
    record Begin(Envelope envelope, Map<String, Double> prior, Long seed) implements WireMessage {}

    /**
     * What should the robot do?
     *
     * @param deadlineMs milliseconds until the answer must be there; null if not said
     */
    record Decide(Envelope envelope, Double deadlineMs) implements WireMessage {}

    /** What an act came to. */
    enum Status { STARTED, COMPLETED, FAILED, CANCELLED }

    /**
     * The robot did something.
     *
     * @param act verb in upper case
     * @param objects that it was about
     * @param pick what became of a pick, {@code NONE} if not said
     */
    record Acted(Envelope envelope, String act, List<String> objects, Status status, PickSignal pick)
            implements WireMessage {}

    /**
     * One reading of what was said.
     *
     * @param confidence in [0, 1]
     */
    record Reading(String transcript, double confidence) {}

    /**
     * The human said something.
     *
     * @param alternatives at least one
     * @param complete whether the recogniser is done with it; else it is not to be filtered
     */
    record Heard(Envelope envelope, List<Reading> alternatives, boolean complete) implements WireMessage {
        /** As the filter takes it. */
        public Speech speech(Vocabulary vocabulary) {
            return new Speech(alternatives.stream().map(a -> new Speech.Alternative(
                    Utterance.parse(a.transcript, vocabulary), a.confidence)).toList());
        }
    }

    /**
     * One arm, in metres.
     *
     * @param hand or wrist
     */
    record Arm(Vector3 hand, Vector3 shoulder) {}

    /**
     * The human pointed.
     *
     * @param arms one, or both if it is not said which one points
     * @param frame of the positions; null for the table's
     */
    record Pointed(Envelope envelope, List<Arm> arms, String frame) implements WireMessage {}

    /**
     * The table changed.
     *
     * @param moved where objects are now, metres
     * @param removed names of objects that are not there any more
     * @param added objects that were not there
     * @param frame of all positions; null for the table's
     */
    record SceneChange(Envelope envelope, Map<String, Vector3> moved, List<String> removed, List<TableObject> added,
            String frame) implements WireMessage {}

    /** What is the state? */
    record State(Envelope envelope) implements WireMessage {}

    /** Close the episode. */
    record End(Envelope envelope) implements WireMessage {}
}
