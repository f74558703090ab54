package handover.solver;

/**
 * A belief and what was decided there, as a table stores it. Arrays must not be modified.
 *
 * @param part its discrete part
 * @param coordinates of b and h under the table's metric, 2n of them
 * @param values estimated value of each act by its index, NaN where there is no estimate
 * @param act the index of the act that was chosen
 */
public record StoredBelief(BeliefPart part, float[] coordinates, float[] values, int act) {}
