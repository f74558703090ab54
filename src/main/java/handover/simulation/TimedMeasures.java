package handover.simulation;

import java.util.List;

/**
 * What one timed episode was worth. Immutable.
 *
 * @param measures with the seconds that it really took
 * @param idle seconds of them without an act
 * @param plannings that were started
 * @param stale acts that were decided on a belief which had changed when they started
 * @param differing those of them that would have been others on the belief of their start
 * @param reaches that were called off; without meaning if the wish changes
 * @param cancels of each objection that was heeded, but for those that were called off before the "no" was out
 */
public record TimedMeasures(Measures measures, double idle, int plannings, int stale, int differing, Reaches reaches, List<Cancel> cancels) {
    public TimedMeasures {
        cancels = List.copyOf(cancels);
    }

    /**
     * How long it took until a reach was called off.
     *
     * @param acts from the one to which the human said no to the other one, 1 for the next
     * @param seconds from the end of the "no" to the start of the other act, at least 0
     */
    public record Cancel(int acts, double seconds) {}
}
