package handover.bridge;

import handover.domain.Adapter;
import handover.domain.DomainSpec;
import handover.io.AdaptedMessage;
import handover.io.WireException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/** A publisher of somebody else, whose topics the domain file's adapters read. Used by one thread. */
final class Feed {
    private static final int MOST = 1000;

    private final ZMQ.Socket socket;
    private final Map<String, Adapter> adapters;

    /**
     * Connects; the publisher need not be there yet.
     *
     * @param option {@code ADDRESS} or {@code ADDRESS,TOPIC}
     * @throws BridgeException if there is no adapter for it
     */
    Feed(ZContext context, String option, DomainSpec domain, long largestFrame) {
        String[] parts = option.split(",", 2);
        Address address = Address.of("subscribe", parts[0]);
        if (address.port().equals("*") || address.host().equals("*")) {
            throw new BridgeException("--subscribe: expected the address of a publisher, got \"" + parts[0] + "\"", null);
        }
        this.adapters = domain.adapters();
        if (adapters.isEmpty() || parts.length == 2 && !adapters.containsKey(parts[1])) {
            throw new BridgeException("--subscribe: expected an adapter for "
                    + (parts.length == 2 ? "the topic \"" + parts[1] + "\"" : "at least one topic") + " in the domain file, which has "
                    + (adapters.isEmpty() ? "none" : String.join(", ", adapters.keySet())), null);
        }
        socket = context.createSocket(SocketType.SUB);
        socket.setLinger(0);
        socket.setMaxMsgSize(largestFrame);
        (parts.length == 2 ? List.of(parts[1]) : adapters.keySet()).forEach(t -> socket.subscribe(t.getBytes(StandardCharsets.UTF_8)));
        address.prepare(socket);
        socket.connect(address.toString());
    }

    ZMQ.Socket socket() {
        return socket;
    }

    /** Hands what was published to the service. */
    void work(Service service) {
        int left = MOST;
        for (List<byte[]> frames = Wire.receive(socket); frames != null; frames = --left > 0 ? Wire.receive(socket) : null) {
            Adapter adapter = adapters.get(new String(frames.get(0), StandardCharsets.UTF_8));
            if (frames.size() != 2) {
                service.malformed(null, "expected a topic and one frame, got " + frames.size() + " frames");
            } else if (adapter != null) {
                take(adapter, frames, service);
            }
        }
    }

    private static void take(Adapter adapter, List<byte[]> frames, Service service) {
        String topic = new String(frames.get(0), StandardCharsets.UTF_8);
        byte[] message;
        try {
            message = AdaptedMessage.of(adapter, topic, frames.get(1));
        } catch (WireException e) {
            service.unusable(topic, e);
            return;
        }
        service.stream(message);
    }
}
