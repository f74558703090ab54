package handover.tabular;

/**
 * An act and why. Immutable.
 *
 * @param act its number
 * @param lower what the belief is worth at least (discounted reward), NaN if not known
 * @param upper what it is worth at most, NaN if not known
 * @param depth how many acts ahead the longest line of thought went
 * @param nodes different beliefs that were weighed
 * @param finished whether the solver did all that its parameters ask for before the deadline
 */
public record TabularDecision(int act, double lower, double upper, int depth, long nodes, boolean finished) {
    /** A decision without look-ahead and without bounds. */
    static TabularDecision of(int act) {
        return new TabularDecision(act, Double.NaN, Double.NaN, 0, 1, true);
    }
}
