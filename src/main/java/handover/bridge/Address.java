package handover.bridge;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.zeromq.ZMQ;
import org.zeromq.ZMQException;

/**
 * Where a socket is bound: {@code tcp://HOST:PORT}, with {@code *} for all interfaces or for any free port.
 *
 * @param option that gave it, for messages
 */
record Address(String option, String host, String port) {
    private static final Pattern TCP = Pattern.compile("tcp://(\\[[0-9a-fA-F:.%]+\\]|[^:/\\[\\]]+):([0-9]{1,5}|\\*)");
    private static final int LARGEST_PORT = 65_535;

    /** Throws {@link BridgeException} for what is no address. */
    static Address of(String option, String text) {
        Matcher m = TCP.matcher(text);
        if (!m.matches() || !m.group(2).equals("*") && Integer.parseInt(m.group(2)) > LARGEST_PORT) {
            throw new BridgeException("--" + option + ": expected tcp://HOST:PORT, got \"" + text + "\"", null);
        }
        return new Address(option, m.group(1), m.group(2).equals("0") ? "*" : m.group(2));
    }

    /** Whether only programs on this machine can reach it. */
    boolean isLoopback() {
        if (host.equals("*")) {
            return false;
        }
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (UnknownHostException e) {
            throw new BridgeException("--" + option + ": there is no host \"" + host + "\"", e);
        }
    }

    /** Throws {@link BridgeException} if it is taken or not on this machine. */
    void bind(ZMQ.Socket socket) {
        ZMQException why = null;
        prepare(socket);
        try {
            if (socket.bind(toString())) {
                return;
            }
        } catch (ZMQException e) {
            why = e;
        }
        throw new BridgeException("--" + option + ": cannot bind " + this
                + ": it is in use already, or not an address of this machine", why);
    }

    /** Lets the socket speak the version of the protocol that the host is written in; to be called before it is connected. */
    void prepare(ZMQ.Socket socket) {
        socket.setIPv6(host.startsWith("["));
    }

    @Override
    public String toString() {
        return "tcp://" + host + ":" + port;
    }
}
