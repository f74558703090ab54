package handover.bridge;

import java.util.List;

/**
 * How a bridge is run. Immutable.
 *
 * @param command address of the command socket
 * @param stream address of the stream socket
 * @param events address of the events socket
 * @param subscribe publishers to connect to, {@code ADDRESS} or {@code ADDRESS,TOPIC}
 * @param security who may talk to it
 * @param seed of the chance that decisions use, unless {@code begin} gives one
 * @param deadlineMs milliseconds for a decision, unless {@code decide} says
 * @param replanThreshold total variation by which the belief may move before a plan is made anew
 * @param limits what is too old, too silent or too much
 */
public record BridgeSettings(String command, String stream, String events, List<String> subscribe, Security security,
        long seed, double deadlineMs, double replanThreshold, Limits limits) {

    /**
     * What is too old, too silent or too much.
     *
     * @param maxAge seconds after which what was sensed is not used any more
     * @param sourceTimeout seconds after which a silent source is reported
     * @param queue how many messages of the stream may wait
     */
    public record Limits(double maxAge, double sourceTimeout, int queue) {}
}
