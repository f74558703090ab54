package handover.bridge;

import handover.domain.HandoverDomain;
import handover.io.SessionLogWriter;
import handover.io.Welcome;
import handover.math.Streams;
import handover.solver.Policy;
import handover.solver.Solver;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/**
 * A running bridge: the sockets of docs/bridge.md and the one thread that owns them and moves the belief. {@link #run} is that
 * thread; {@link #stop} may be called by any other.
 */
public final class Bridge implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Bridge.class);
    /** Larger frames are not even taken off the wire; smaller ones are answered with what is wrong with them. */
    private static final long LARGEST_FRAME = 16L << 20;
    private static final String WAKE = "inproc://wake";
    /** So many requests are answered, and for so long messages of the stream applied, before the others' turn. */
    private static final int REQUESTS = 64;
    /** So many messages of the stream are taken at once, and may wait in a socket. */
    private static final int STREAMED = 5000;
    private static final long WORK_NANOS = 1_000_000;
    /** What was said last may take so long to get out, in milliseconds. */
    private static final int LAST_WORDS_MS = 300;
    /** For so long what waits is still applied when the bridge is told to stop. */
    private static final long FINISH_NANOS = 1_000_000_000;
    private static final long MILLI = 1_000_000;

    private final ZContext context = new ZContext();
    /** Null if nothing is encrypted. */
    private final Gatekeeper gatekeeper;
    private final ZMQ.Socket command;
    private final ZMQ.Socket stream;
    private final ZMQ.Socket events;
    private final ZMQ.Socket wake;
    /** Rings {@link #wake}; guarded by itself. */
    private final ZMQ.Socket bell;
    private final List<Feed> feeds;
    private final Subscriptions subscriptions = new Subscriptions();
    private final Queue<Planner.Plan> plans = new ConcurrentLinkedQueue<>();
    private final CountDownLatch ended = new CountDownLatch(1);
    private final BridgeSettings settings;
    private final Policy policy;
    private final Welcome welcome;
    private volatile boolean stopping;

    /**
     * Binds the sockets and gets ready to decide.
     *
     * @throws BridgeException if that is not possible
     */
    public Bridge(HandoverDomain domain, Solver solver, BridgeSettings settings) {
        this.settings = settings;
        context.setLinger(LAST_WORDS_MS);
        try {
            gatekeeper = settings.security().server() == null ? null
                    : new Gatekeeper(context, settings.security().authorized());
            command = bind(SocketType.ROUTER, settings.command(), "command", settings.security());
            stream = bind(SocketType.PULL, settings.stream(), "stream", settings.security());
            events = bind(SocketType.XPUB, settings.events(), "events", settings.security());
            feeds = settings.subscribe().stream().map(f -> new Feed(context, f, domain.spec(), LARGEST_FRAME)).toList();
            wake = context.createSocket(SocketType.PULL);
            wake.bind(WAKE);
            bell = context.createSocket(SocketType.PUSH);
            bell.connect(WAKE);
            Map<String, String> sockets = new LinkedHashMap<>();
            sockets.put("command", command.getLastEndpoint());
            sockets.put("stream", stream.getLastEndpoint());
            sockets.put("events", events.getLastEndpoint());
            welcome = new Welcome(domain, solver.name(), sockets);
            policy = solver.solve(domain, Streams.of(settings.seed(), "solve", 0));
            WarmUp.run(domain, policy, welcome, System::nanoTime);
        } catch (RuntimeException e) {
            context.close();
            throw e;
        }
    }

    private ZMQ.Socket bind(SocketType type, String text, String name, Security security) {
        Address address = Address.of(name, text);
        security.check(address);
        ZMQ.Socket socket = context.createSocket(type);
        security.secure(socket);
        socket.setLinger(LAST_WORDS_MS);
        socket.setMaxMsgSize(LARGEST_FRAME);
        socket.setRcvHWM(STREAMED);
        address.bind(socket);
        return socket;
    }

    /** What it says of itself. */
    public Welcome welcome() {
        return welcome;
    }

    /**
     * Serves until {@link #stop} is called.
     *
     * @param start what is known
     * @param log receives what is applied and answered; null for none. It stays open
     */
    public void run(Recovery start, SessionLogWriter log) {
        List<ZMQ.Socket> sockets = new ArrayList<>(List.of(wake, command, stream, events));
        if (gatekeeper != null) {
            sockets.add(gatekeeper.socket());
        }
        feeds.forEach(f -> sockets.add(f.socket()));
        try (ZMQ.Poller poller = context.createPoller(sockets.size());
                Service service = new Service(start.session(), policy, welcome, settings, new Sockets(), log,
                        () -> System.currentTimeMillis() / 1e3, System::nanoTime, this::hand)) {
            service.restore(start.answered(), start.closed());
            sockets.forEach(s -> poller.register(s, ZMQ.Poller.POLLIN));
            boolean more = false;
            while (!stopping) {
                poller.poll(more ? 0 : milliseconds(service.untilDue()));
                more = turnSafely(service);
            }
            finish(service);
        } finally {
            synchronized (bell) {
                stopping = true;
                context.close();
            }
            ended.countDown();
        }
    }

    /** What was sensed before the end still counts, if there is not too much of it. */
    private void finish(Service service) {
        long start = System.nanoTime();
        while (turnSafely(service) && System.nanoTime() - start < FINISH_NANOS) {
            Thread.onSpinWait();
        }
    }

    private static long milliseconds(long nanos) {
        return nanos == Long.MAX_VALUE ? -1 : Math.max(0, (nanos + MILLI - 1) / MILLI);
    }

    /** Whatever goes wrong with one message must not stop the others. */
    private boolean turnSafely(Service service) {
        try {
            return turn(service);
        } catch (RuntimeException e) {
            LOG.error("something could not be handled", e);
            return false;
        }
    }

    /** Handles what has come; whether there is more to do. */
    private boolean turn(Service service) {
        while (wake.recv(ZMQ.DONTWAIT) != null) {
            for (Planner.Plan plan = plans.poll(); plan != null; plan = plans.poll()) {
                service.planned(plan);
            }
        }
        if (gatekeeper != null) {
            gatekeeper.work();
        }
        for (byte[] change = events.recv(ZMQ.DONTWAIT); change != null; change = events.recv(ZMQ.DONTWAIT)) {
            subscriptions.change(change);
        }
        receive(service);
        int left = REQUESTS;
        for (List<byte[]> frames = Wire.receive(command); frames != null; frames = --left > 0 ? Wire.receive(command) : null) {
            request(frames, service);
        }
        boolean more = service.work(WORK_NANOS);
        service.tick();
        return more;
    }

    /** Takes what the sensors sent, before the commands: what was sensed before an act is not to seem later than it. */
    private void receive(Service service) {
        for (int left = STREAMED; left > 0 && service.hasRoom(); left--) {
            List<byte[]> frames = Wire.receive(stream);
            if (frames == null) {
                break;
            } else if (frames.size() == 1) {
                service.stream(frames.get(0));
            } else {
                service.malformed(null, "expected one frame, got " + frames.size());
            }
        }
        if (service.hasRoom()) {
            feeds.forEach(f -> f.work(service));
        }
    }

    private static void request(List<byte[]> frames, Service service) {
        Client client = new Client(frames.get(0));
        if (frames.size() == 3 && frames.get(1).length == 0) {
            service.command(client, frames.get(2));
        } else {
            service.malformed(client, "expected an empty frame and one with the message, got " + (frames.size() - 1)
                    + " frames");
        }
    }

    /** Called by the planner's thread. */
    private void hand(Planner.Plan plan) {
        plans.add(plan);
        knock();
    }

    private void knock() {
        synchronized (bell) {
            if (!context.isClosed()) {
                bell.send(new byte[0], ZMQ.DONTWAIT);
            }
        }
    }

    /** Ends {@link #run} and waits for it, at most so long; whether it ended. */
    public boolean stop(long milliseconds) throws InterruptedException {
        stopping = true;
        knock();
        return ended.await(milliseconds, TimeUnit.MILLISECONDS);
    }

    /** Gives the sockets up; only if {@link #run} was never called. */
    @Override
    public void close() {
        context.close();
    }

    private final class Sockets implements Outbox {
        @Override
        public void reply(Client client, String json) {
            command.send(client.identity(), ZMQ.SNDMORE);
            command.send(new byte[0], ZMQ.SNDMORE);
            command.send(json.getBytes(StandardCharsets.UTF_8), ZMQ.DONTWAIT);
        }

        @Override
        public void publish(String topic, Supplier<String> json) {
            if (subscriptions.wants(topic)) {
                byte[] event = json.get().getBytes(StandardCharsets.UTF_8);
                events.sendMore(topic);
                events.send(event, ZMQ.DONTWAIT);
            }
        }
    }
}
