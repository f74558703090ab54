package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.solver.Confirm;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/** Only who has an authorised key is heard or hears anything. */
class SecurityTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("table-line-6");

    @TempDir
    Path folder;

    private static BridgeSettings settings(String command, Security security) {
        BridgeSettings s = RunningBridge.SETTINGS;
        return new BridgeSettings(command, s.stream(), s.events(), List.of(), security, 1, 100, 0.1, s.limits());
    }

    @Test
    void strangersGetNothingAndDisturbNobody() throws IOException {
        CurveKeys.generate(folder.resolve("server"));
        Path clients = Files.createDirectory(folder.resolve("clients"));
        CurveKeys robot = CurveKeys.generate(clients.resolve("robot"));
        CurveKeys stranger = CurveKeys.generate(folder.resolve("stranger"));
        CurveKeys server = CurveKeys.server(folder.resolve("server.key_secret"));
        Security security = new Security(server, CurveKeys.authorized(clients), false);
        assertEquals(Set.of(robot.publicKey()), security.authorized());
        Bridge bridge = new Bridge(DOMAIN, new Confirm(), settings("tcp://127.0.0.1:*", security));
        Thread thread = new Thread(() -> bridge.run(Recovery.none(DOMAIN, 1, 2), null));
        thread.start();
        try (ZContext context = new ZContext()) {
            ZMQ.Socket known = client(context, SocketType.REQ, bridge, "command", robot, server);
            ZMQ.Socket hears = client(context, SocketType.SUB, bridge, "events", robot, server);
            ZMQ.Socket deaf = client(context, SocketType.SUB, bridge, "events", stranger, server);
            ZMQ.Socket pushes = client(context, SocketType.PUSH, bridge, "stream", stranger, server);
            ZMQ.Socket asks = client(context, SocketType.REQ, bridge, "command", stranger, server);
            ZMQ.Socket plain = client(context, SocketType.REQ, bridge, "command", null, null);
            pushes.send("{\"v\":1,\"type\":\"begin\"}", ZMQ.DONTWAIT);
            asks.send("{\"v\":1,\"type\":\"begin\"}", ZMQ.DONTWAIT);
            plain.send("{\"v\":1,\"type\":\"begin\"}", ZMQ.DONTWAIT);
            assertEquals("heartbeat", hears.recvStr());
            known.send("{\"v\":1,\"type\":\"begin\"}");
            JsonNode begun = RunningBridge.json(known.recv());
            assertEquals(1, begun.get("belief").asInt(), "nobody else's begin was heard");
            for (ZMQ.Socket s : List.of(deaf, asks, plain)) {
                s.setReceiveTimeOut(500);
                assertNull(s.recv());
            }
            known.send("{\"v\":1,\"type\":\"state\"}");
            assertEquals(1, RunningBridge.json(known.recv()).get("belief_version").asInt());
        } finally {
            stop(bridge, thread);
        }
    }

    private static void stop(Bridge bridge, Thread thread) {
        try {
            assertTrue(bridge.stop(20_000));
            thread.join();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private static ZMQ.Socket client(ZContext context, SocketType type, Bridge bridge, String name, CurveKeys own, CurveKeys server) {
        ZMQ.Socket socket = context.createSocket(type);
        socket.setReceiveTimeOut(20_000);
        socket.setLinger(0);
        if (own != null) {
            socket.setCurvePublicKey(ZMQ.Curve.z85Decode(own.publicKey()));
            socket.setCurveSecretKey(ZMQ.Curve.z85Decode(own.secret()));
            socket.setCurveServerKey(ZMQ.Curve.z85Decode(server.publicKey()));
        }
        if (type == SocketType.SUB) {
            socket.subscribe("");
        }
        socket.connect(bridge.welcome().sockets().get(name));
        return socket;
    }

    @ParameterizedTest
    @ValueSource(strings = {"tcp://*:*", "tcp://0.0.0.0:*", "tcp://[::]:*"})
    void withoutEncryptionOnlyThisMachine(String address) {
        BridgeException e = refused(address, Security.LOOPBACK);
        assertTrue(e.getMessage().startsWith("--command: " + address + " can be reached from other machines"), e.getMessage());
        try (Bridge bridge = new Bridge(DOMAIN, new Confirm(), settings("tcp://0.0.0.0:*", new Security(null, Set.of(), true)))) {
            assertTrue(bridge.welcome().sockets().get("command").startsWith("tcp://0.0.0.0:"));
        }
    }

    @Test
    void theOtherInternetProtocol() throws InterruptedException {
        try (ServerSocket probe = new ServerSocket()) {
            probe.bind(new InetSocketAddress("::1", 0));
        } catch (IOException e) {
            assumeTrue(false, "this machine has no IPv6: " + e.getMessage());
        }
        try (Bridge bridge = new Bridge(DOMAIN, new Confirm(), settings("tcp://[::1]:*", Security.LOOPBACK)); ZContext context = new ZContext()) {
            String address = bridge.welcome().sockets().get("command");
            Thread serving = new Thread(() -> bridge.run(Recovery.none(DOMAIN, 1, 2), null));
            serving.start();
            ZMQ.Socket client = context.createSocket(SocketType.REQ);
            client.setIPv6(true);
            client.setLinger(0);
            client.setReceiveTimeOut(20_000);
            client.connect("tcp://[::1]" + address.substring(address.lastIndexOf(':')));
            client.send("{\"v\":1,\"type\":\"hello\"}");
            assertEquals("welcome", RunningBridge.json(client.recv()).get("type").asText(), address);
            assertTrue(bridge.stop(20_000));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "tcp://127.0.0.1", "tcp://127.0.0.1:70000", "udp://127.0.0.1:1", "127.0.0.1:5701", "tcp://a b:1",
        "tcp://127.0.0.1:x", "tcp://there.is.no.such.host.invalid:5701"})
    void addressesAreChecked(String address) {
        assertTrue(refused(address, Security.LOOPBACK).getMessage().startsWith("--command: "));
    }

    @Test
    void anAddressThatIsInUse() {
        try (Bridge first = new Bridge(DOMAIN, new Confirm(), settings("tcp://127.0.0.1:*", Security.LOOPBACK))) {
            String taken = first.welcome().sockets().get("command");
            assertEquals("--command: cannot bind " + taken + ": it is in use already, or not an address of this machine",
                    refused(taken, Security.LOOPBACK).getMessage());
        }
    }

    private static BridgeException refused(String address, Security security) {
        return assertThrows(BridgeException.class, () -> new Bridge(DOMAIN, new Confirm(), settings(address, security)).close());
    }

    @Test
    void keyFiles() throws IOException {
        Path name = folder.resolve("server");
        CurveKeys keys = CurveKeys.generate(name);
        assertThrows(BridgeException.class, () -> CurveKeys.generate(name), "it is not overwritten");
        Path secret = folder.resolve("server.key_secret");
        assertEquals(keys, CurveKeys.server(secret));
        assertFalse(keys.toString().contains(keys.secret()));
        assertFalse(Files.readString(folder.resolve("server.key")).contains(keys.secret()));
        assertThrows(BridgeException.class, () -> CurveKeys.server(folder.resolve("server.key")), "only the public one");
        Path nothing = folder.resolve("nothing");
        assertThrows(BridgeException.class, () -> CurveKeys.server(nothing));
        assertThrows(BridgeException.class, () -> CurveKeys.authorized(nothing));
        assertThrows(BridgeException.class, () -> CurveKeys.authorized(Files.createDirectory(nothing)));
        Files.writeString(nothing.resolve("bad.key"), "curve\n    public-key = \"short\"\n");
        assertTrue(assertThrows(BridgeException.class, () -> CurveKeys.authorized(nothing)).getMessage()
                .endsWith("bad.key: public-key: expected 40 characters of Z85"));
        assumeTrue(secret.getFileSystem().supportedFileAttributeViews().contains("posix"));
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(secret)));
        Files.setPosixFilePermissions(secret, PosixFilePermissions.fromString("rw-r-----"));
        assertTrue(assertThrows(BridgeException.class, () -> CurveKeys.server(secret)).getMessage()
                .endsWith("expected mode 600, got rw-r-----"));
    }
}
