package handover.bridge;

import java.util.List;

/** What events are published under (docs/bridge.md). */
final class Topics {
    static final String BELIEF = "belief";
    static final String DECISION = "decision";
    static final String ACT = "act";
    static final String ERROR = "error";
    static final String HEARTBEAT = "heartbeat";
    static final String SCENE = "scene";
    static final String EPISODE = "episode";

    static final List<String> ALL = List.of(BELIEF, DECISION, ACT, ERROR, HEARTBEAT, SCENE, EPISODE);

    private Topics() {}
}
