"""The scripts as processes: help, what is wrong in a line with exit code 2, and the live view."""
import os
import signal
import subprocess
import sys
import unittest

SCRIPTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, SCRIPTS)
from client import zmq  # noqa: E402
from load import punctuality  # noqa: E402
from watch import View  # noqa: E402

NAMES = ["sensor_sim.py", "robot_sim.py", "speech_pocketsphinx.py", "gesture_mediapipe.py", "record.py", "watch.py", "load.py"]
DEAD = "tcp://127.0.0.1:1"


def script(name, *arguments):
    return subprocess.run([sys.executable, os.path.join(SCRIPTS, name), *arguments], capture_output=True, text=True, timeout=60)


def hear_ctrl_c():
    """Whoever runs these tests in the background may have turned it off."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class ScriptsTest(unittest.TestCase):
    def test_each_has_help(self):
        for name in NAMES:
            with self.subTest(name):
                done = script(name, "--help")
                self.assertEqual(0, done.returncode, done.stderr)
                self.assertIn("usage: " + name, done.stdout)

    def test_what_is_wrong_is_one_line(self):
        for name, arguments, problem in (
                ("record.py", ["--bridge", "nowhere"], "nowhere: expected an address such as tcp://"),
                ("record.py", ["--bridge", DEAD, "--out", "/nowhere/x"], "/nowhere/x: No such file or directory"),
                ("watch.py", ["--key", "x"], "expected both --key and --server-key"),
                ("watch.py", ["--key", "x", "--server-key", "/nowhere"], "/nowhere: expected a key file"),
                ("sensor_sim.py", ["--bridge", DEAD], "the bridge did not answer a hello"),
                ("gesture_mediapipe.py", ["--camera", "0"], "expected --model"),
                ("gesture_mediapipe.py", ["--landmarks", "/nowhere", "--dry-run"], "/nowhere: No such file or directory"),
                ("gesture_mediapipe.py", ["--landmarks", "/nowhere", "--fov", "200"], "--fov: expected degrees"),
                ("gesture_mediapipe.py", ["--landmarks", sys.executable, "--dry-run"], ":1: expected a picture's landmarks"),
                ("robot_sim.py", ["--scale", "-1"], "--scale: expected a number of at least 0, got -1.0"),
                ("robot_sim.py", ["--scale", "inf"], "--scale: expected a number of at least 0, got inf"),
                ("robot_sim.py", ["--acts", "0"], "--acts: expected a whole number of at least 1, got 0"),
                ("record.py", ["--bridge", DEAD, "--topic", "act", "--topic", "nope"],
                 "--topic: expected one of belief, decision, act, error, heartbeat, scene, episode, got nope"),
                ("record.py", ["--bridge", DEAD, "--topic", ""], "heartbeat, scene, episode, got "),
                ("sensor_sim.py", ["--scale", "nan"], "--scale: expected a number above 0, got nan"),
                ("sensor_sim.py", ["--scale", "0"], "--scale: expected a number above 0, got 0.0"),
                ("sensor_sim.py", ["--scale", "-0.5"], "--scale: expected a number above 0, got -0.5"),
                ("sensor_sim.py", ["--scale", "inf"], "--scale: expected a number above 0, got inf"),
                ("sensor_sim.py", ["--handovers", "0"], "--handovers: expected a whole number of at least 1, got 0"),
                ("sensor_sim.py", ["--handovers", "-3"], "--handovers: expected a whole number of at least 1, got -3"),
                ("sensor_sim.py", ["--bridge", DEAD, "--domain", __file__], "test_scripts.py: expected JSON"),
                ("robot_sim.py", ["--hand", "foo"], "--hand foo: expected keyboard or an address such as tcp://"),
                ("plot_episode.py", [], "expected LOG EPISODE SOLVER"),
                ("plot_episode.py", ["/nowhere", "0", "confirm"], "/nowhere: No such file or directory"),
                ("plot_episode.py", ["/nowhere", "first", "confirm"], "expected the number of an episode, got first"),
                ("plot_episode.py", [__file__, "0", "confirm"], "test_scripts.py: expected a log of handover simulate"),
                ("plot_episode.py", [os.devnull, "0", "confirm"], "there is no episode 0 of confirm"),
                ("speech_pocketsphinx.py", ["--dry-run"], "expected --domain"),
                ("speech_pocketsphinx.py", ["--dry-run", "--domain", __file__], "test_scripts.py: expected JSON")):
            with self.subTest(name + str(arguments)):
                done = script(name, *arguments)
                self.assertEqual(2, done.returncode, done.stderr)
                self.assertEqual(1, done.stderr.count("\n"), done.stderr)
                self.assertIn(problem, done.stderr)

    def test_ctrl_c_is_quiet(self):
        for name in ("record.py", "watch.py", "sensor_sim.py", "robot_sim.py", "load.py"):
            with self.subTest(name), zmq.Context() as context, context.socket(zmq.ROUTER) as bridge:
                port = bridge.bind_to_random_port("tcp://127.0.0.1")
                more = ["speech"] if name == "load.py" else []
                process = subprocess.Popen([sys.executable, os.path.join(SCRIPTS, name), "--bridge", f"tcp://127.0.0.1:{port}", *more],
                                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=hear_ctrl_c)
                self.assertTrue(bridge.poll(30000), "it asks")
                process.send_signal(signal.SIGINT)
                self.assertEqual((b"", b""), process.communicate(timeout=30))
                self.assertEqual(130, process.returncode)
                bridge.linger = 0

    def test_usage_is_checked(self):
        done = script("gesture_mediapipe.py")
        self.assertEqual(2, done.returncode)
        self.assertIn("one of the arguments --camera --image --landmarks is required", done.stderr)


class PunctualityTest(unittest.TestCase):
    def test_no_reply_is_late(self):
        self.assertEqual("none of 3 replies came after its deadline", punctuality([0.0, 0.0, 0.0]))

    def test_the_others_are_on_time(self):
        self.assertEqual("2 of 4 replies came after their deadline (the others count as 0 ms): p50 1.50 ms, p99 2.50 ms, "
                         "largest 2.50 ms, n = 4", punctuality([2.5, 0.0, 1.5, 0.0]))


class ViewTest(unittest.TestCase):
    def view(self):
        view = View("two")
        view.take("belief", {"belief": {"cup": 0.75, "box": 0.25}, "human_belief": {"cup": 0.5, "box": 0.5}})
        view.take("act", {"act": "ASK", "objects": ["cup"], "status": "started"})
        return view

    def test_a_line_says_the_likeliest_and_the_latest(self):
        self.assertEqual("robot: cup 0.750 | person: cup 0.500 | started ASK(cup)", self.view().line())

    def test_a_picture_has_bars_and_fits(self):
        picture = self.view().picture(62)
        self.assertIn("cup  0.750 " + "#" * 14 + " " * 4, picture)
        self.assertIn("box  0.250 " + "#" * 4 + " ", picture)
        self.assertTrue(all(len(line) <= 62 for line in picture.splitlines()))

    def test_a_belief_version_is_no_belief(self):
        view = self.view()
        view.take("act", {"act": "WAIT", "objects": [], "status": "completed", "belief": 12})
        self.assertIn("cup 0.750", view.line())


if __name__ == "__main__":
    unittest.main()
