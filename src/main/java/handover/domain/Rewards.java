package handover.domain;

import handover.math.MatchScore;

/**
 * The reward parts that are not the price of an act (MODEL section 6). Immutable.
 *
 * @param right R+, paid when a pick of the wanted object completes
 * @param wrong R-, paid when a pick of another object completes
 * @param annoyance paid for repeating the communicative act that is still the open reference
 * @param matchWeight kappa, the weight of the match score
 * @param matchScore S(b, h')
 * @param discount gamma in [0, 1)
 */
public record Rewards(double right, double wrong, double annoyance, double matchWeight, MatchScore matchScore,
        double discount) {
    /** Bound on the size of any one reward. */
    static final double LARGEST = 1e6;

    /** Checks every field; throws {@link InvalidParameterException}. */
    public Rewards {
        Check.within("right", right, -LARGEST, LARGEST, "a reward");
        Check.within("wrong", wrong, -LARGEST, LARGEST, "a reward");
        Check.within("annoyance", annoyance, -LARGEST, LARGEST, "a reward");
        Check.within("match_weight", matchWeight, 0, LARGEST, "a weight");
        Check.present("match_score", matchScore, "a match score");
        if (!(discount >= 0 && discount < 1)) {
            throw new InvalidParameterException("discount", discount, "a discount in [0, 1)");
        }
    }
}
