package handover.simulation;

import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.Observation;
import handover.domain.Speech;
import handover.domain.Utterance;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * When people react. Once they understood an act (after the robot's words, if it says any; at the end of a pick that completes;
 * else at its start) they begin to speak and to point after a reaction time each; what they say is known when its last word was
 * said, a gesture when the arm is up. To an act that refers to nothing nobody reacts: what people then say and show of
 * themselves comes at any time while it runs. Immutable, thread safe.
 *
 * @param reaction from understanding to speaking, and to pointing
 * @param perWord seconds that a word takes, the robot's as the human's; from 0 to 10
 * @param spread the part of an act that refers to nothing in which people speak up, in [0, 1]
 * @param sensing seconds from the last word, or the raised arm, until the sensors report it; from 0 to 60
 */
public record ResponseTimes(Delay reaction, double perWord, double spread, double sensing) {
    /** People, and a speech recogniser that waits for the end of what is said. */
    public static final ResponseTimes DEFAULT = new ResponseTimes(new Delay.LogNormal(0.5, 0.4), 0.3, 1, 0.2);
    /** Everything is sensed the moment an act starts, or a pick completed: the time of the untimed simulator. */
    public static final ResponseTimes NONE = new ResponseTimes(new Delay.Fixed(0), 0, 0, 0);

    /** Throws {@link IllegalArgumentException} for parameters outside their ranges. */
    public ResponseTimes {
        if (!(perWord >= 0 && perWord <= 10 && spread >= 0 && spread <= 1 && sensing >= 0 && sensing <= 60)) {
            throw new IllegalArgumentException("expected 0 to 10 s a word, a spread in [0, 1] and 0 to 60 s for sensing, got "
                    + perWord + ", " + spread + " and " + sensing);
        }
    }

    /** The same people with another reaction time. */
    public ResponseTimes with(Delay other) {
        return new ResponseTimes(other, perWord, spread, sensing);
    }

    /**
     * When what people do in reaction to an act arrives, speech before gesture.
     *
     * @param start of the act, seconds
     * @param duration of the act, seconds
     * @param completes whether it is a pick that completed
     * @param o what they say and show
     * @param random draws the same times whatever {@code o} is
     */
    List<Arrival> arrivals(double start, ActModel act, double duration, boolean completes, Observation o, RandomGenerator random) {
        double toSpeak;
        double toPoint;
        if (act.match() == null) {
            toSpeak = start + spread * duration * random.nextDouble();
            toPoint = start + spread * duration * random.nextDouble();
        } else {
            double understood = start + (completes ? duration : perWord * words(act.say()));
            toSpeak = understood + reaction.seconds(random) + (o.speech() == null ? 0 : perWord * words(o.speech()));
            toPoint = understood + reaction.seconds(random);
        }
        List<Arrival> all = new ArrayList<>();
        if (o.speech() != null) {
            all.add(new Arrival(toSpeak, toSpeak + sensing, o.speech(), null));
        }
        if (o.gesture() != null) {
            all.add(new Arrival(toPoint, toPoint + sensing, null, o.gesture()));
        }
        return all;
    }

    private static int words(String said) {
        return said.isBlank() ? 0 : said.trim().split("\\s+").length;
    }

    private static int words(Speech speech) {
        Utterance u = speech.alternatives().get(0).utterance();
        return (u.answer() == Answer.NONE ? 0 : 1) + u.content().size() + u.negated().size() + u.unknown().size();
    }
}
