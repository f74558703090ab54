package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/** A client's ends of the three sockets, which sends whatever it is told to. */
final class WireClient implements AutoCloseable {
    private static final int PATIENCE_MS = 30_000;

    private final ZContext context = new ZContext();
    private final ZMQ.Socket command;
    private final ZMQ.Socket stream;
    private final ZMQ.Socket events;

    WireClient(BridgeProcess bridge) {
        command = connect(SocketType.DEALER, bridge.address("command"));
        stream = connect(SocketType.PUSH, bridge.address("stream"));
        events = connect(SocketType.SUB, bridge.address("events"));
        context.setLinger(0);
    }

    private ZMQ.Socket connect(SocketType type, String address) {
        ZMQ.Socket socket = context.createSocket(type);
        socket.setReceiveTimeOut(PATIENCE_MS);
        socket.setHWM(0);
        socket.connect(address);
        return socket;
    }

    /** Sends a request, single quotes for double ones, and returns the reply. */
    JsonNode ask(String json) throws IOException {
        send(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
        return reply();
    }

    /** Like {@link #ask}, for a request that is to be accepted. */
    JsonNode must(String json) throws IOException {
        JsonNode reply = ask(json);
        assertEquals(false, reply.get("type").asText().equals("error"), () -> json + " -> " + reply);
        return reply;
    }

    void send(byte[] message) {
        sendFrames(new byte[0], message);
    }

    void sendFrames(byte[]... frames) {
        for (int k = 0; k < frames.length; k++) {
            command.send(frames[k], k < frames.length - 1 ? ZMQ.SNDMORE : 0);
        }
    }

    /** The next reply. */
    JsonNode reply() throws IOException {
        byte[] frame = command.recv();
        assertNotNull(frame, "no reply");
        while (command.hasReceiveMore()) {
            frame = command.recv();
        }
        return BridgeProcess.JSON.readTree(frame);
    }

    /** A reply if one comes within so many milliseconds, else null. */
    JsonNode replyWithin(int milliseconds) throws IOException {
        command.setReceiveTimeOut(milliseconds);
        byte[] frame = command.recv();
        command.setReceiveTimeOut(PATIENCE_MS);
        while (frame != null && command.hasReceiveMore()) {
            frame = command.recv();
        }
        return frame == null ? null : BridgeProcess.JSON.readTree(frame);
    }

    void push(byte[]... frames) {
        for (int k = 0; k < frames.length; k++) {
            stream.send(frames[k], k < frames.length - 1 ? ZMQ.SNDMORE : 0);
        }
    }

    void push(String json) {
        push(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    }

    /** Listens to a topic, and waits until the bridge knows it. */
    void listen(String... topics) throws IOException {
        events.subscribe("heartbeat");
        for (String topic : topics) {
            events.subscribe(topic);
        }
        until(e -> e.get("type").asText().equals("heartbeat"));
        events.unsubscribe("heartbeat");
    }

    /** The next heartbeat; no other topic is listened to any more. */
    JsonNode heartbeat() throws IOException {
        List.of("belief", "decision", "act", "error", "scene", "episode").forEach(events::unsubscribe);
        events.subscribe("heartbeat");
        return until(e -> e.get("type").asText().equals("heartbeat"));
    }

    /** The next event that is as wanted. */
    JsonNode until(Predicate<JsonNode> wanted) throws IOException {
        while (true) {
            assertNotNull(events.recv(), "no such event");
            JsonNode event = BridgeProcess.JSON.readTree(events.recv());
            if (wanted.test(event)) {
                return event;
            }
        }
    }

    /** What is published within so many milliseconds, as topic and text. */
    List<String> heardWithin(int milliseconds) {
        List<String> heard = new ArrayList<>();
        long end = System.nanoTime() + milliseconds * 1_000_000L;
        for (long left = milliseconds; left > 0; left = (end - System.nanoTime()) / 1_000_000) {
            events.setReceiveTimeOut((int) left);
            String frame = events.recvStr();
            if (frame != null) {
                heard.add(frame + " " + events.recvStr());
            }
        }
        events.setReceiveTimeOut(PATIENCE_MS);
        return heard;
    }

    @Override
    public void close() {
        context.close();
    }
}
