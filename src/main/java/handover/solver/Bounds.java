package handover.solver;

/**
 * Between what the value of a belief lies (expected discounted reward). Immutable.
 *
 * @param lower not more than what is earned by a policy that is known; on handover domains the match part of that is approximate
 * @param upper not less than what any policy can earn
 */
public record Bounds(double lower, double upper) {
    /** Throws {@link IllegalArgumentException} if the bounds cross by more than rounding, or are not numbers. */
    public Bounds {
        if (!(lower <= upper + 1e-6 * (1 + Math.abs(upper)))) {
            throw new IllegalArgumentException("expected lower <= upper, got " + lower + " and " + upper);
        }
    }
}
