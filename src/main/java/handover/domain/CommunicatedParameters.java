package handover.domain;

import handover.math.MatchScore;
import java.util.Locale;

/**
 * What is paid for being understood in the variants in which the human's expectation is a hidden object (MODEL 7).
 * Immutable.
 *
 * @param reward paid if the human expects what they want; the weight of the score
 * @param score linear, the report's; or a proper score of the expectation instead
 */
public record CommunicatedParameters(double reward, MatchScore score) {

    /** Checks every field; throws {@link InvalidParameterException}. */
    public CommunicatedParameters {
        Check.within("reward", reward, 0, Rewards.LARGEST, "a reward");
        Check.present("score", score, "a match score");
        if (score.beliefDependent()) {
            throw new InvalidParameterException("score", score.name().toLowerCase(Locale.ROOT),
                    "linear, brier, log or none, because the state is rewarded, not the belief");
        }
    }
}
