package handover.bridge;

/** Python programs that stop half way: real clients that die at the worst moment. */
final class HalfWay {
    /** Opens a connection as a PUSH or DEALER socket would (ZMTP 3.0), sends half of a frame, says so, and waits to be killed. */
    static final String MID_FRAME = """
            import socket, struct, sys, time
            kind, port, shape = sys.argv[1], int(sys.argv[2]), sys.argv[3]
            s = socket.create_connection(("127.0.0.1", port))
            s.sendall(b"\\xff" + bytes(8) + b"\\x7f\\x03\\x00" + b"NULL".ljust(20, b"\\0") + bytes(32))
            def get(n):
                data = b""
                while len(data) < n:
                    piece = s.recv(n - len(data))
                    assert piece, "closed"
                    data += piece
                return data
            get(64)
            ready = b"\\x05READY" + b"\\x0bSocket-Type" + struct.pack(">I", len(kind)) + kind.encode()
            s.sendall(bytes([4, len(ready)]) + ready)
            flags, length = get(2)
            get(length)
            message = b'{"v":1,"type":"speech","text":"red red red red"}'
            if shape == "frame":      # a long frame of which half never comes
                s.sendall(b"\\x02" + struct.pack(">Q", 2 * len(message)) + message)
            else:                     # a whole first frame of two
                s.sendall(bytes([1, 0]) if kind == "DEALER" else bytes([1, len(message)]) + message)
            print("sent", flush=True)
            time.sleep(600)
            """;

    /** Begins an episode, asks for a decision, and waits to be killed before it is there. */
    static final String AFTER_DECIDE = """
            import json, sys, time
            from client import Bridge
            bridge = Bridge(sys.argv[1], source="robot")
            bridge.ask("begin")
            bridge._command.send_multipart([b"", json.dumps(bridge._message("decide", {"deadline_ms": 3000})).encode()])
            print("asked", flush=True)
            time.sleep(600)
            """;

    /** Listens to everything and never reads it. */
    static final String DEAF = """
            import sys, time, zmq
            from client import Bridge
            bridge = Bridge(sys.argv[1])
            address = bridge._socket("events")
            events = bridge._context.socket(zmq.SUB)
            events.rcvhwm = 1
            events.rcvbuf = 4096
            events.connect(address)
            events.subscribe("")
            print("deaf", flush=True)
            time.sleep(600)
            """;

    private HalfWay() {}
}
