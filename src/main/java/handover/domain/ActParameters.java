package handover.domain;

/**
 * What one type of act costs and what people do in reply (MODEL 4.1, 4.2, 6, 9). Immutable.
 *
 * @param reward paid for each act (for each increment of a pick), usually negative
 * @param duration seconds (of a whole pick)
 * @param speechRate phi, the probability that the human says content words
 * @param gestureRate the probability that the human points
 * @param answerIfMatch r_match, the probability of an answer if the human takes the act to mean what they want
 * @param answerIfMiss r_miss, the probability of an answer if not
 */
public record ActParameters(double reward, double duration, double speechRate, double gestureRate,
        double answerIfMatch, double answerIfMiss) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public ActParameters {
        Check.within("reward", reward, -Rewards.LARGEST, Rewards.LARGEST, "a reward");
        Check.within("duration", duration, 0, 3600, "seconds");
        Check.probability("speech_rate", speechRate);
        Check.probability("gesture_rate", gestureRate);
        Check.probability("answer_if_match", answerIfMatch);
        Check.probability("answer_if_miss", answerIfMiss);
    }
}
