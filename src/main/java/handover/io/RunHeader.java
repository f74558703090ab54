package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.DomainSpec;
import java.util.List;

/**
 * What a run of simulated episodes is a function of; the first line of its log. Immutable.
 *
 * @param domain as the robot sees it
 * @param people the domain as people are; equal to {@code domain} if they are as the robot believes
 * @param seed of the run
 * @param solvers their names, in the order in which they play
 * @param episodes for each solver
 * @param maxSteps at which an episode is cut off
 * @param deadlineMs milliseconds for each decision, 0 for no deadline
 * @param time what is assumed of time; null if the run is not timed
 */
public record RunHeader(DomainSpec domain, DomainSpec people, long seed, List<String> solvers, int episodes, int maxSteps,
        int deadlineMs, RunTime time) {
    static final String FORMAT = "handover-episodes";
    static final int VERSION = 1;

    public RunHeader {
        solvers = List.copyOf(solvers);
    }

    /** Whether people are as the robot believes. */
    public boolean asModelled() {
        return people.equals(domain);
    }

    /** How many episodes there are in all. */
    public long total() {
        return (long) episodes * solvers.size() * (time == null ? 1 : time.agents().size());
    }

    ObjectNode json() {
        ObjectNode tree = Json.object().put("format", FORMAT).put("version", VERSION)
                .put("domain_hash", DomainFiles.hash(domain)).put("seed", seed);
        tree.set("solvers", Json.list(solvers));
        tree.put("episodes", episodes).put("max_steps", maxSteps);
        tree.put("deadline_ms", deadlineMs == 0 ? null : deadlineMs);
        if (time != null) {
            tree.set("timed", time.json());
        }
        tree.set("domain", DomainFiles.toJson(domain));
        if (!asModelled()) {
            tree.set("people", DomainFiles.toJson(people));
        }
        return tree;
    }

    /**
     * The header of a log.
     *
     * @throws FieldException for what is not a header
     * @throws DomainFileException for a domain that cannot be meant
     */
    static RunHeader of(JsonNode tree, String source) {
        Fields f = new Fields(tree, "");
        f.oneOf("format", List.of(FORMAT));
        f.whole("version", VERSION, VERSION);
        DomainSpec domain = DomainFiles.fromJson(f.object("domain").node(), source + ": domain");
        DomainSpec people = f.has("people") ? DomainFiles.fromJson(f.object("people").node(), source + ": people") : domain;
        if (!f.text("domain_hash").equals(DomainFiles.hash(domain))) {
            throw f.wrong("domain_hash", DomainFiles.hash(domain) + ", which is the hash of the domain in this log");
        }
        return new RunHeader(domain, people, f.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE), f.texts("solvers"),
                (int) f.whole("episodes", 1, Integer.MAX_VALUE), (int) f.whole("max_steps", 1, Integer.MAX_VALUE),
                f.has("deadline_ms") ? (int) f.whole("deadline_ms", 1, Integer.MAX_VALUE) : 0,
                f.has("timed") ? RunTime.of(f.object("timed")) : null);
    }
}
