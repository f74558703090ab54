package handover.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.SessionLogWriter;
import handover.solver.Solver;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/** A bridge on free ports with its own thread, and sockets to talk to it. Used by one thread. */
final class RunningBridge implements AutoCloseable {
    static final BridgeSettings SETTINGS = new BridgeSettings("tcp://127.0.0.1:*", "tcp://127.0.0.1:*", "tcp://127.0.0.1:*",
            List.of(), Security.LOOPBACK, 1, 2000, 0.1, new BridgeSettings.Limits(2, 10, 5000));
    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final int PATIENCE_MS = 20_000;

    private final Bridge bridge;
    private final Thread thread;
    private final ZContext context = new ZContext();
    private final ZMQ.Socket request;
    private final ZMQ.Socket push;
    private final ZMQ.Socket events;

    private RunningBridge(Bridge bridge, Recovery start, SessionLogWriter log) {
        this.bridge = bridge;
        this.thread = new Thread(() -> bridge.run(start, log), "bridge");
        thread.start();
        request = client(SocketType.REQ, "command");
        push = client(SocketType.PUSH, "stream");
        events = context.createSocket(SocketType.SUB);
        events.setReceiveTimeOut(PATIENCE_MS);
        events.subscribe("");
        events.connect(address("events"));
    }

    static RunningBridge of(String domain, Solver solver) {
        HandoverDomain on = DomainFiles.load(domain);
        return of(on, solver, SETTINGS, Recovery.none(on, 1, 2), null);
    }

    static RunningBridge of(HandoverDomain domain, Solver solver, BridgeSettings settings, Recovery start, SessionLogWriter log) {
        return new RunningBridge(new Bridge(domain, solver, settings), start, log);
    }

    String address(String socket) {
        return bridge.welcome().sockets().get(socket);
    }

    /** Another socket of the same kind of client. */
    ZMQ.Socket client(SocketType type, String socket) {
        ZMQ.Socket client = context.createSocket(type);
        client.setReceiveTimeOut(PATIENCE_MS);
        client.setLinger(0);
        client.connect(address(socket));
        return client;
    }

    /** The answer to a request, with single for double quotes. */
    JsonNode ask(String json) {
        return ask(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    }

    JsonNode ask(byte[] message) {
        request.send(message);
        return json(request.recv());
    }

    void push(String json) {
        push.send(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    }

    /** The next event of a topic. */
    JsonNode event(String topic) {
        while (true) {
            String got = events.recvStr();
            if (got == null) {
                throw new AssertionError("no event " + topic);
            }
            JsonNode event = json(events.recv());
            if (got.equals(topic)) {
                return event;
            }
        }
    }

    /** All that was published up to now. */
    List<JsonNode> eventsSoFar() {
        List<JsonNode> all = new ArrayList<>();
        for (String topic = events.recvStr(ZMQ.DONTWAIT); topic != null; topic = events.recvStr(ZMQ.DONTWAIT)) {
            all.add(json(events.recv()));
        }
        return all;
    }

    /** The state once so many messages of the stream have been counted. */
    JsonNode stateAfter(long streamed) throws InterruptedException {
        for (int k = 0; k < 1000; k++) {
            JsonNode state = ask("{'v':1,'type':'state'}");
            if (state.path("counters").path("streamed").asLong() >= streamed && handled(state.get("counters")) >= streamed) {
                return state;
            }
            Thread.sleep(20);
        }
        throw new AssertionError(ask("{'v':1,'type':'state'}").toString());
    }

    private static long handled(JsonNode counters) {
        return counters.path("applied").asLong() + counters.path("shed").asLong() + counters.path("errors").asLong()
                + counters.path("repeated").asLong() + counters.path("unfinal").asLong();
    }

    static JsonNode json(byte[] text) {
        try {
            return MAPPER.readTree(text);
        } catch (IOException e) {
            throw new AssertionError(text == null ? "no answer" : new String(text, StandardCharsets.UTF_8), e);
        }
    }

    boolean stop() {
        try {
            boolean stopped = bridge.stop(PATIENCE_MS);
            thread.join(PATIENCE_MS);
            return stopped && !thread.isAlive();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void close() {
        context.close();
        if (!stop()) {
            throw new AssertionError("the bridge did not stop");
        }
    }
}
