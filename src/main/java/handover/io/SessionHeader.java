package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.DomainSpec;
import java.util.List;

/**
 * What a session of a bridge starts from; the first line of its log. Immutable.
 *
 * @param solver that decides
 * @param seed of the chance that decisions use, unless {@code begin} gives one
 * @param maxAge seconds after which what was sensed is not used any more
 */
public record SessionHeader(DomainSpec domain, String solver, long seed, double maxAge) {
    static final String FORMAT = "handover-session";
    private static final int VERSION = 1;
    private static final double LONGEST = 3600;

    ObjectNode json() {
        ObjectNode tree = Json.object().put("format", FORMAT).put("version", VERSION)
                .put("domain_hash", DomainFiles.hash(domain)).put("solver", solver).put("seed", seed).put("max_age", maxAge);
        tree.set("domain", DomainFiles.toJson(domain));
        return tree;
    }

    /**
     * The header of a log.
     *
     * @throws FieldException for what is not a header
     * @throws DomainFileException for a domain that cannot be meant
     */
    static SessionHeader of(JsonNode tree, String source) {
        Fields f = new Fields(tree, "");
        f.oneOf("format", List.of(FORMAT));
        f.whole("version", VERSION, VERSION);
        DomainSpec domain = DomainFiles.fromJson(f.object("domain").node(), source + ": domain");
        return new SessionHeader(domain, f.text("solver"), f.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE),
                f.number("max_age", 0, LONGEST, "seconds"));
    }
}
