"""A small client of `handover bridge`: commands with replies, a stream of sensor messages, and events.

    from client import Bridge

    with Bridge() as bridge:                                # tcp://127.0.0.1:5701
        bridge.ask("begin")
        bridge.ask("speech", text="the red ball")
        decision = bridge.ask("decide", deadline_ms=500)    # {"act": "ASK", "objects": ["red_ball"], ...}
        bridge.acted(decision, "started")
        ...                                                 # the robot moves
        bridge.acted(decision, "completed")

Needs pyzmq. Messages and fields are those of the bridge's protocol, version 1. A Bridge is used by one thread.
"""
import argparse
import importlib
import itertools
import json
import os
import secrets
import sys
import time
from typing import Any, Callable, Dict, Iterator, NamedTuple, NoReturn, Optional, Tuple
from urllib.parse import urlsplit

ADDRESS = "tcp://127.0.0.1:5701"
PASSING = {"no_episode", "stale", "busy"}  # codes of what came at a bad moment
TOPICS = ["belief", "decision", "act", "error", "heartbeat", "scene", "episode"]  # of events


def fail(problem: str) -> NoReturn:
    """Ends the script with a line on standard error and exit code 2."""
    print(f"{os.path.basename(sys.argv[0])}: {problem}", file=sys.stderr)
    sys.exit(2)


def need(module: str, install: str) -> Any:
    """A module, or the end of the script with what installs it."""
    try:
        return importlib.import_module(module)
    except (ImportError, OSError) as e:
        fail(f"{e}; this installs what is missing: {install}")


zmq = need("zmq", "pip install -r scripts/requirements.txt")


class Refused(Exception):
    """The bridge answered with an error.

    code: one of the protocol's, such as "bad_field", or "superseded"; path: the field, such as "hand[1]"
    """

    def __init__(self, reply: Dict[str, Any]):
        self.code, self.path = reply.get("code", ""), reply.get("path", "")
        super().__init__(f"{self.code}: {self.path + ': ' if self.path else ''}{reply.get('message', '')}")


class NoAnswer(Exception):
    """The bridge did not answer in time."""


class BadInput(Exception):
    """A file, an option or a value that cannot be used."""


class Keys(NamedTuple):
    """CURVE keys as `handover bridge keygen` writes them.

    server: file with the bridge's public key; own: file with the client's secret key, whose public half the bridge knows
    """

    server: str
    own: str

    def put_on(self, socket: Any) -> None:
        auth = importlib.import_module("zmq.auth")
        server, _ = self._load(auth, self.server)
        public, secret = self._load(auth, self.own)
        if secret is None:
            raise BadInput(f"{self.own}: expected a file with a secret key")
        socket.curve_serverkey, socket.curve_publickey, socket.curve_secretkey = server, public, secret

    @staticmethod
    def _load(auth: Any, path: str) -> Tuple[bytes, Optional[bytes]]:
        try:
            return auth.load_certificate(path)
        except (OSError, ValueError) as e:
            raise BadInput(f"{path}: expected a key file of `handover bridge keygen` ({e})") from e


class Bridge:
    """A connection to a bridge, of which only the command address must be known: the bridge tells the others.

    address: of its command socket; source: who sends, in every message; keys: for a bridge that runs with --curve;
    timeout: seconds to wait for a reply; tries: how often a message is sent, with the same id, so that it is applied once
    """

    def __init__(self, address: str = ADDRESS, source: str = "python", keys: Optional[Keys] = None, timeout: float = 2.0,
                 tries: int = 3):
        self.address, self.source, self.keys, self.timeout, self.tries = address, source, keys, timeout, tries
        self._ids = map(f"{source}-{secrets.token_hex(4)}-{{}}".format, itertools.count(1))
        self._context = zmq.Context()
        self._welcome: Optional[Dict[str, Any]] = None
        self._stream: Any = None
        self._events: Any = None
        try:
            self._command = self._connect(zmq.DEALER, address)
            self._command.sndtimeo = int(timeout * 1000)
        except Exception:
            self._context.destroy(linger=0)
            raise

    def ask(self, type: str, **fields: Any) -> Dict[str, Any]:
        """Sends a message and returns the reply.

        Raises Refused if that is an error, NoAnswer if none comes. A decide may take its deadline_ms longer than others.
        """
        message = self._message(type, fields)
        wait = self.timeout + fields.get("deadline_ms", 0) / 1000
        for attempt in range(self.tries):
            until = time.monotonic() + wait
            try:
                self._command.send_multipart([b"", _encode(message)])
            except zmq.Again:
                continue  # there is no connection, and will be none if the keys are wrong
            while self._command.poll(max(0.0, until - time.monotonic()) * 1000):
                reply = json.loads(self._command.recv_multipart()[-1])
                if reply.get("re") != message["id"] or attempt and reply["type"] == "superseded":
                    continue  # it is about an earlier try
                if reply["type"] == "superseded":
                    raise Refused({"code": "superseded", "message": "another decide came before this one was answered"})
                if reply["type"] == "error":
                    raise Refused(reply)
                return reply
        raise NoAnswer(f"{self.address}: the bridge did not answer a {type} in {self.tries} x {wait:g} s"
                       + ("" if self.keys else "; is it running, and without --curve?"))

    def sensed(self, type: str, **fields: Any) -> Optional[Dict[str, Any]]:
        """As ask, for what was heard or seen: None, and a line on standard error, if it came at a bad moment."""
        try:
            return self.ask(type, **fields)
        except Refused as e:
            if e.code not in PASSING:
                raise
            print(e, file=sys.stderr)
            return None

    def hello(self) -> Dict[str, Any]:
        """What the bridge said when it was first asked: the domain, its objects, acts and sockets."""
        if self._welcome is None:
            self._welcome = self.ask("hello")
        return self._welcome

    def acted(self, decision: Dict[str, Any], status: str, pick: Optional[str] = None) -> Dict[str, Any]:
        """Reports what became of an act: status started, completed, failed or cancelled; pick moving, accepted or rejected."""
        signal = {} if pick is None else {"pick": pick}
        return self.ask("acted", act=decision["act"], objects=decision.get("objects", []), status=status, **signal)

    def push(self, type: str, **fields: Any) -> bool:
        """Sends a sensor message without waiting for a reply; False if the bridge is gone and too many wait already."""
        if self._stream is None:
            self._stream = self._connect(zmq.PUSH, self._socket("stream"))
            self._stream.linger = 1000
        try:
            self._stream.send(_encode(self._message(type, fields)), zmq.NOBLOCK)
            return True
        except zmq.Again:
            return False

    def subscribe(self, *topics: str) -> Any:
        """From now on hears of these topics (all if none is named); returns the socket, for a poller."""
        if self._events is None:
            self._events = self._connect(zmq.SUB, self._socket("events"))
        for topic in topics or ("",):
            self._events.subscribe(topic)
        return self._events

    def next_event(self, timeout: Optional[float] = None) -> Optional[Tuple[str, Dict[str, Any]]]:
        """The next topic and event, None if there is none for so many seconds."""
        if not self._events.poll(None if timeout is None else timeout * 1000):
            return None
        topic, event = self._events.recv_multipart()
        return topic.decode(), json.loads(event)

    def events(self, *topics: str) -> Iterator[Tuple[str, Dict[str, Any]]]:
        """Topics and events as they come, for ever."""
        self.subscribe(*topics)
        while True:
            event = self.next_event()
            if event is not None:
                yield event

    def close(self) -> None:
        """Waits at most a second for what was pushed to be sent."""
        self._context.destroy()

    def __enter__(self) -> "Bridge":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _message(self, type: str, fields: Dict[str, Any]) -> Dict[str, Any]:
        return {"v": 1, "type": type, "id": next(self._ids), "source": self.source, **fields}

    def _connect(self, kind: int, address: str) -> Any:
        socket = self._context.socket(kind)
        socket.linger = 0
        socket.ipv6 = int("[" in address)
        if self.keys:
            self.keys.put_on(socket)
        try:
            socket.connect(address)
        except zmq.ZMQError as e:
            raise BadInput(f"{address}: expected an address such as {ADDRESS} ({e})") from e
        return socket

    def _socket(self, name: str) -> str:
        """Another of its addresses, on the host by which it was reached."""
        host, port = urlsplit(self.address).hostname, urlsplit(self.hello()["sockets"][name]).port
        return f"tcp://{'[' + host + ']' if host and ':' in host else host}:{port}"


def _encode(message: Dict[str, Any]) -> bytes:
    return json.dumps(message, allow_nan=False, separators=(",", ":")).encode()


def options(description: str) -> argparse.ArgumentParser:
    """A parser with the options that all scripts share; the first paragraph of the description is for --help."""
    parser = argparse.ArgumentParser(description=description.split("\n\n")[0])
    parser.add_argument("--bridge", metavar="ADDRESS", default=ADDRESS, help="its command socket (default: %(default)s)")
    parser.add_argument("--key", metavar="FILE", help="own secret key, for a bridge that runs with --curve")
    parser.add_argument("--server-key", metavar="FILE", help="the bridge's public key, with --key")
    return parser


def connect(given: argparse.Namespace, source: str) -> Bridge:
    """The bridge that the shared options name."""
    if (given.key is None) != (given.server_key is None):
        fail("expected both --key and --server-key, or neither")
    return Bridge(given.bridge, source, Keys(given.server_key, given.key) if given.key else None)


def run(main: Callable[[], Optional[int]]) -> NoReturn:
    """Runs a script: Ctrl-C ends it quietly with 130, what was wrong outside it with a line and 2."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except OSError as e:
        fail(f"{e.filename}: {e.strerror}" if e.filename else str(e))
    except (Refused, NoAnswer, BadInput) as e:
        fail(str(e))
