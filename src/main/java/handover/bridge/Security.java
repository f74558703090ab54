package handover.bridge;

import java.util.Set;
import org.zeromq.ZMQ;

/**
 * Who may talk to a bridge. Immutable.
 *
 * @param server its keys; null for no encryption
 * @param authorized public keys of the clients that may connect, in Z85
 * @param insecure whether it may be reached from other machines without encryption
 */
public record Security(CurveKeys server, Set<String> authorized, boolean insecure) {
    /** For this machine only. */
    public static final Security LOOPBACK = new Security(null, Set.of(), false);

    static final String ZAP_DOMAIN = "handover";

    public Security {
        authorized = Set.copyOf(authorized);
    }

    /** Throws {@link BridgeException} if this address must not be bound. */
    void check(Address address) {
        if (server == null && !insecure && !address.isLoopback()) {
            throw new BridgeException("--" + address.option() + ": " + address + " can be reached from other machines, but nothing "
                    + "is encrypted; give --curve and --authorized, or --insecure to do so all the same", null);
        }
    }

    /** Makes a socket ask for keys. */
    void secure(ZMQ.Socket socket) {
        if (server != null) {
            socket.setZAPDomain(ZAP_DOMAIN);
            socket.setCurveServer(true);
            socket.setCurvePublicKey(ZMQ.Curve.z85Decode(server.publicKey()));
            socket.setCurveSecretKey(ZMQ.Curve.z85Decode(server.secret()));
        }
    }
}
