package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.cli.Main;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A bridge with keys: who has no authorised one gets nothing and cannot disturb the others. */
class CurveTest {
    /** Tries all three sockets, and prints how many answers and events it got. */
    private static final String CLIENT = """
            import json, sys, time, zmq
            from client import Bridge, Keys, NoAnswer
            command, stream, events, server, own, patience = sys.argv[1:7]
            keys = None if own == "none" else Keys(server, own)
            with Bridge(command, source="stranger", keys=keys, timeout=float(patience), tries=1) as bridge:
                push, listen = bridge._connect(zmq.PUSH, stream), bridge._connect(zmq.SUB, events)
                listen.subscribe("")
                answers = heard = 0
                for message in ({"type": "hello"}, {"type": "speech", "text": "red"}):
                    try:
                        answers += bridge.ask(**message)["type"] in ("welcome", "ok")
                    except NoAnswer:
                        pass
                    for _ in range(50):
                        try:
                            push.send(json.dumps({"v": 1, "type": "speech", "text": "black spoon"}).encode(), zmq.NOBLOCK)
                        except zmq.Again:
                            pass
                end = time.monotonic() + 3
                while time.monotonic() < end:
                    heard += listen.poll(100) != 0 and len(listen.recv_multipart()) == 2
                print(f"answers {answers} heard {heard > 0}")
            """;

    @TempDir
    Path folder;

    @Test
    void onlyAuthorisedClientsGetAnythingOrChangeAnything() throws Exception {
        Python.assumeZmq();
        Path clients = Files.createDirectory(folder.resolve("clients"));
        keygen(folder.resolve("server"));
        keygen(clients.resolve("robot"));
        keygen(folder.resolve("stranger"));
        keygen(folder.resolve("otherserver"));
        try (BridgeProcess bridge = BridgeProcess.start(folder, "bowls-and-spoons", "--solver", "confirm", "--curve",
                folder.resolve("server.key_secret").toString(), "--authorized", clients.toString());
                Python robot = Python.program(folder, """
                        import sys
                        from client import Bridge, Keys
                        with Bridge(sys.argv[1], keys=Keys(sys.argv[2], sys.argv[3]), timeout=10) as bridge:
                            bridge.ask("begin")
                            print("begun", flush=True)
                            sys.stdin.readline()
                            bridge.ask("speech", text="silver")
                            print("version", bridge.ask("state")["belief_version"], flush=True)
                        """, bridge.address("command"), folder.resolve("server.key"), clients.resolve("robot.key_secret"))) {
            robot.untilPrinted("begun");
            assertEquals("answers 0 heard False", client(bridge, "server.key", "none", 1.5),
                    "without any key");
            assertEquals("answers 0 heard False", client(bridge, "server.key", "stranger.key_secret", 1.5),
                    "with a key of its own making");
            assertEquals("answers 0 heard False", client(bridge, "otherserver.key", "clients/robot.key_secret", 1.5),
                    "taking another for the bridge");
            robot.process().getOutputStream().write('\n');
            robot.process().getOutputStream().flush();
            assertTrue(robot.ended(0).contains("version 2"), robot.text());
            assertEquals("answers 2 heard True", client(bridge, "server.key", "clients/robot.key_secret", 30), "with an authorised key");
            String secret = Files.readString(folder.resolve("server.key_secret")).split("secret-key = \"")[1].split("\"")[0];
            assertTrue(!bridge.errors().contains(secret) && !bridge.ready().toString().contains(secret), "a secret was printed");
        }
    }

    private String client(BridgeProcess bridge, String serverKey, String key, double patience) throws Exception {
        try (Python client = Python.program(folder, CLIENT, bridge.address("command"), bridge.address("stream"), bridge.address("events"),
                folder.resolve(serverKey), key.equals("none") ? key : folder.resolve(key), patience)) {
            return client.ended(0).strip();
        }
    }

    private static void keygen(Path name) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code = Main.run(new String[] {"bridge", "keygen", name.toString()}, new ByteArrayInputStream(new byte[0]),
                new PrintStream(new ByteArrayOutputStream()), new PrintStream(err, true, StandardCharsets.UTF_8));
        assertEquals(0, code, err.toString(StandardCharsets.UTF_8));
    }
}
