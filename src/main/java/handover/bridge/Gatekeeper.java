package handover.bridge;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/**
 * Says which clients may connect: those whose key is on the list. Used by one thread.
 *
 * <p>Source: ZeroMQ RFC 27, the ZeroMQ Authentication Protocol.
 */
final class Gatekeeper {
    private static final Logger LOG = LoggerFactory.getLogger(Gatekeeper.class);
    private static final String ENDPOINT = "inproc://zeromq.zap.01";
    private static final int REQUEST_FRAMES = 7;
    private static final int MOST_REPORTED = 100;

    private final ZMQ.Socket socket;
    private final Set<String> authorized;
    private final Set<String> reported = new HashSet<>();

    /** To be made before any socket is bound, or some would get in unseen. */
    Gatekeeper(ZContext context, Set<String> authorized) {
        this.authorized = authorized;
        this.socket = context.createSocket(SocketType.REP);
        socket.setLinger(0);
        socket.bind(ENDPOINT);
    }

    ZMQ.Socket socket() {
        return socket;
    }

    /** Answers the clients that wait. */
    void work() {
        for (List<byte[]> request = Wire.receive(socket); request != null; request = Wire.receive(socket)) {
            String key = key(request);
            boolean welcome = key != null && authorized.contains(key);
            if (!welcome && reported.size() < MOST_REPORTED && reported.add(String.valueOf(key))) {
                LOG.warn("a client without an authorised key was turned away: {}", key);
            }
            socket.send("1.0", ZMQ.SNDMORE);
            socket.send(request.size() > 1 ? request.get(1) : new byte[0], ZMQ.SNDMORE);
            socket.send(welcome ? "200" : "400", ZMQ.SNDMORE);
            socket.send(welcome ? "OK" : "not authorised", ZMQ.SNDMORE);
            socket.send(welcome ? key : "", ZMQ.SNDMORE);
            socket.send(new byte[0], 0);
        }
    }

    /** The client's key; null if the request has none. */
    private static String key(List<byte[]> request) {
        boolean curve = request.size() == REQUEST_FRAMES
                && new String(request.get(5), StandardCharsets.UTF_8).equals("CURVE") && request.get(6).length == 32;
        return curve ? ZMQ.Curve.z85Encode(request.get(6)) : null;
    }
}
