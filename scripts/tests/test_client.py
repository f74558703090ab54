"""The client against a bridge that answers as the test says."""
import contextlib
import io
import json
import os
import sys
import threading
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
import client  # noqa: E402
from client import Bridge, NoAnswer, Refused, zmq  # noqa: E402


class Answering:
    """A ROUTER socket in a thread. answers: the replies to the messages in order, each a list of dicts; re is put in."""

    def __init__(self, *answers):
        self.seen = []
        self._context = zmq.Context()
        self._socket = self._context.socket(zmq.ROUTER)
        self.address = f"tcp://127.0.0.1:{self._socket.bind_to_random_port('tcp://127.0.0.1')}"
        self._thread = threading.Thread(target=self._serve, args=(answers,))
        self._thread.start()

    def _serve(self, answers):
        for replies in answers:
            who, empty, message = self._socket.recv_multipart()
            self.seen.append(json.loads(message))
            for reply in replies:
                self._socket.send_multipart([who, empty, json.dumps({"v": 1, "re": self.seen[-1]["id"], **reply}).encode()])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._thread.join()
        self._context.destroy(linger=1000)


class ClientTest(unittest.TestCase):
    def test_asks_and_is_answered(self):
        with Answering([{"type": "ok", "belief": 7}]) as other, Bridge(other.address, source="mic") as bridge:
            self.assertEqual(7, bridge.ask("speech", text="red")["belief"])
        sent = other.seen[0]
        self.assertEqual((1, "speech", "mic", "red"), (sent["v"], sent["type"], sent["source"], sent["text"]))

    def test_tries_again_with_the_same_id(self):
        with Answering([], [{"type": "ok", "belief": 1}]) as other, Bridge(other.address, timeout=0.3) as bridge:
            bridge.ask("speech", text="red")
        self.assertEqual(other.seen[0], other.seen[1])

    def test_skips_the_late_reply_to_an_earlier_message(self):
        late = {"type": "ok", "re": "old", "belief": 1}
        with Answering([late, {"type": "ok", "belief": 2}]) as other, Bridge(other.address) as bridge:
            self.assertEqual(2, bridge.ask("state")["belief"])

    def test_what_is_sensed_at_a_bad_moment_is_passed_over(self):
        late = {"type": "error", "code": "no_episode", "message": "there is no episode"}
        with Answering([late], [{**late, "code": "bad_field"}]) as other, Bridge(other.address) as bridge:
            with contextlib.redirect_stderr(io.StringIO()) as told:
                self.assertIsNone(bridge.sensed("speech", text="red"))
            self.assertEqual("no_episode: there is no episode\n", told.getvalue())
            with self.assertRaises(Refused):
                bridge.sensed("speech", text=3)

    def test_an_error_is_raised_with_code_and_path(self):
        error = {"type": "error", "code": "bad_field", "path": "hand[1]", "message": "expected a number"}
        with Answering([error]) as other, Bridge(other.address) as bridge:
            with self.assertRaisesRegex(Refused, r"^bad_field: hand\[1\]: expected a number$") as raised:
                bridge.ask("gesture")
        self.assertEqual(("bad_field", "hand[1]"), (raised.exception.code, raised.exception.path))

    def test_a_superseded_decision_is_an_error_but_not_if_one_superseded_it_oneself(self):
        superseded, decision = {"type": "superseded"}, {"type": "decision", "act": "WAIT"}
        with Answering([superseded]) as other, Bridge(other.address) as bridge, self.assertRaisesRegex(Refused, "superseded: another"):
            bridge.ask("decide")
        with Answering([], [superseded, decision]) as other, Bridge(other.address, timeout=0.3) as bridge:
            self.assertEqual("WAIT", bridge.ask("decide")["act"])

    def test_silence_is_an_error(self):
        with Bridge("tcp://127.0.0.1:1", timeout=0.05) as bridge, self.assertRaisesRegex(NoAnswer, "3 x 0.05 s"):
            bridge.ask("state")

    def test_a_decision_may_take_its_deadline_longer(self):
        with Bridge("tcp://127.0.0.1:1", timeout=0.05, tries=1) as bridge, self.assertRaisesRegex(NoAnswer, "1 x 0.25 s"):
            bridge.ask("decide", deadline_ms=200)

    def test_finds_the_other_sockets_on_the_same_host(self):
        pull = zmq.Context.instance().socket(zmq.PULL)
        port = pull.bind_to_random_port("tcp://127.0.0.1")
        welcome = {"type": "welcome", "sockets": {"stream": f"tcp://0.0.0.0:{port}"}}
        with Answering([welcome]) as other, Bridge(other.address, source="kinect") as bridge:
            self.assertTrue(bridge.push("gesture", hand=[0, 0, 0]))
            self.assertTrue(pull.poll(5000))
            self.assertEqual("kinect", json.loads(pull.recv())["source"])
        pull.close()

    def test_ids_of_two_clients_differ(self):
        with Bridge(source="a") as one, Bridge(source="a") as two:
            self.assertEqual(4, len({b._message("state", {})["id"] for b in (one, two, one, two)}))

    def test_what_is_not_a_number_is_not_sent(self):
        with Bridge() as bridge, self.assertRaises(ValueError):
            bridge.ask("gesture", hand=[0, float("nan"), 0])

    def test_a_bad_address_is_named(self):
        with self.assertRaisesRegex(client.BadInput, "nowhere: expected an address such as tcp://"):
            Bridge("nowhere")


if __name__ == "__main__":
    unittest.main()
