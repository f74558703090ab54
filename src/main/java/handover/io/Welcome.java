package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.ActType;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import java.util.Map;

/**
 * What a bridge says of itself.
 *
 * @param solver that decides
 * @param sockets name to address
 */
public record Welcome(HandoverDomain domain, String solver, Map<String, String> sockets) {

    /** The answer to {@code hello}; {@code scene} is what is on the table now. */
    public String reply(String re, Scene scene) {
        return Json.line(tree("welcome", re, scene));
    }

    /**
     * What is printed when the sockets are bound.
     *
     * @param log file; null for none
     * @param version of the belief from which it goes on
     * @param scene what is on the table
     */
    public String ready(String log, long version, Scene scene) {
        ObjectNode tree = tree("ready", null, scene).put("belief_version", version);
        return Json.line(log == null ? tree : tree.put("log", log));
    }

    private ObjectNode tree(String type, String re, Scene scene) {
        ObjectNode tree = Replies.envelope(type, re).put("protocol", Messages.VERSION).put("domain", domain.spec().name())
                .put("domain_hash", DomainFiles.hash(domain.spec())).put("variant", domain.spec().variant());
        tree.set("objects", Json.scene(scene));
        tree.set("acts", Json.list(domain.types().stream().map(ActType::verb).toList()));
        tree.put("increments", domain.pickRule().increments());
        domain.types().forEach(t -> tree.withObjectProperty("durations").put(t.verb(), t.parameters().duration()));
        tree.set("shoulder", Json.list(domain.spec().shoulder()));
        tree.set("frames", Json.list(domain.spec().frames().keySet()));
        tree.put("solver", solver);
        sockets.forEach(tree.putObject("sockets")::put);
        return tree;
    }
}
