package handover.domain;

import burlap.mdp.core.state.State;
import java.util.List;

/**
 * All that was sensed in one step (MODEL section 4). Immutable.
 *
 * @param speech what was heard, null for silence
 * @param gesture where the human pointed, null if nowhere
 * @param signal what became of a pick
 */
public record Observation(Speech speech, Gesture gesture, PickSignal signal) implements State {
    /** Nothing was sensed. */
    public static final Observation NOTHING = new Observation(null, null, PickSignal.NONE);

    private static final List<Object> KEYS = List.of("speech", "gesture", "signal");

    @Override
    public List<Object> variableKeys() {
        return KEYS;
    }

    @Override
    public Object get(Object key) {
        return switch (String.valueOf(key)) {
            case "speech" -> speech;
            case "gesture" -> gesture;
            case "signal" -> signal;
            default -> throw new IllegalArgumentException("an observation has the variables " + KEYS + ", not " + key);
        };
    }

    @Override
    public Observation copy() {
        return this;
    }
}
