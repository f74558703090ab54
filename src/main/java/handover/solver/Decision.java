package handover.solver;

import handover.domain.Act;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * An act and why. Immutable.
 *
 * @param act what to do
 * @param values estimated value of each act that was considered (discounted reward), in table order; may be empty
 * @param depth how many acts ahead the values look, 0 if the policy does not look ahead
 * @param nodes beliefs that were visited
 * @param finished whether the solver did all that its parameters ask for before the deadline
 * @param note what is unusual about how the decision was made, for instance that a fallback made it; empty if nothing is
 * @param bounds between what the value of the belief lies; null if the solver does not know
 */
public record Decision(Act act, Map<Act, Double> values, int depth, long nodes, boolean finished, String note, Bounds bounds) {
    public Decision {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /** A decision without bounds. */
    public Decision(Act act, Map<Act, Double> values, int depth, long nodes, boolean finished, String note) {
        this(act, values, depth, nodes, finished, note, null);
    }

    /** A decision made as usual, without bounds. */
    public Decision(Act act, Map<Act, Double> values, int depth, long nodes, boolean finished) {
        this(act, values, depth, nodes, finished, "", null);
    }

    /** The same decision with another note. */
    public Decision noted(String text) {
        return new Decision(act, values, depth, nodes, finished, text, bounds);
    }

    /** A decision without look-ahead. */
    public static Decision of(Act act) {
        return new Decision(act, Map.of(), 0, 1, true);
    }
}
