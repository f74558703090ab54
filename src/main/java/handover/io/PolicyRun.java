package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.DomainSpec;
import handover.solver.BeliefMetric;
import java.util.ArrayList;
import java.util.List;

/**
 * What a precomputed policy is a function of. Immutable.
 *
 * @param domain name of the domain
 * @param domainHash its {@link DomainFiles#hash}
 * @param teacher whose decisions are stored, as on the command line
 * @param pointMs milliseconds that the teacher had for each, 0 for no limit; with a limit the policy also depends on the machine
 * @param beliefs how many distinct beliefs were asked for
 * @param seed of the simulated episodes and of the teacher
 * @param people hashes of the domains of the simulated people other than the model
 * @param metric name of the distance between beliefs
 * @param humanWeight what h counts in it against b
 */
public record PolicyRun(String domain, String domainHash, String teacher, int pointMs, int beliefs, long seed,
        List<String> people, String metric, double humanWeight) {
    public PolicyRun {
        people = List.copyOf(people);
    }

    /** The run with these people and the default metric. */
    public static PolicyRun of(DomainSpec domain, String teacher, int pointMs, int beliefs, long seed, List<DomainSpec> people) {
        return new PolicyRun(domain.name(), DomainFiles.hash(domain), teacher, pointMs, beliefs, seed,
                people.stream().map(DomainFiles::hash).toList(), BeliefMetric.NAME, BeliefMetric.DEFAULT.humanWeight());
    }

    BeliefMetric beliefMetric() {
        return new BeliefMetric(humanWeight);
    }

    ObjectNode json() {
        return RecordMapper.tree(this);
    }

    static PolicyRun of(JsonNode tree, String source) {
        return RecordMapper.bind(tree, PolicyRun.class, Place.of(source));
    }

    /** How this run differs from another one, in words; empty if it does not. */
    public String differences(PolicyRun other) {
        List<String> found = new ArrayList<>();
        JsonNode mine = json();
        JsonNode theirs = other.json();
        mine.fieldNames().forEachRemaining(key -> {
            if (!mine.get(key).equals(theirs.get(key))) {
                found.add(key + " " + mine.get(key) + ", not " + theirs.get(key));
            }
        });
        return String.join("; ", found);
    }
}
