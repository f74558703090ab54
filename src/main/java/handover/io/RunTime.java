package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;

/**
 * What a timed run assumes of time, in the words of the command line. Immutable.
 *
 * @param agents their names, in the order in which they play
 * @param planningLatency how long a decision takes
 * @param reaction how long people take
 * @param replan by how much the belief must move for the concurrent robot to think again
 * @param patience how long after an act it may begin to
 */
public record RunTime(List<String> agents, String planningLatency, String reaction, double replan, String patience) {
    public RunTime {
        agents = List.copyOf(agents);
    }

    ObjectNode json() {
        return RecordMapper.tree(this);
    }

    /** @throws FieldException for what does not say it */
    static RunTime of(Fields f) {
        return new RunTime(f.texts("agents"), f.text("planning_latency"), f.text("reaction"), f.number("replan"), f.text("patience"));
    }
}
