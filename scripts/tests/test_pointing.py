"""Landmarks to gestures, on the fixture that bodies.py makes, whose truth is known."""
import json
import math
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import bodies  # noqa: E402
from client import BadInput  # noqa: E402
from gesture_mediapipe import messages, recorded  # noqa: E402
from person import angle, minus  # noqa: E402
from pointing import COUNT, Frame, Gestures, place, pointing_arm  # noqa: E402

FIXTURE = os.path.join(HERE, "landmarks.ndjson")


def frames():
    return list(recorded(FIXTURE))


class PointingTest(unittest.TestCase):
    def test_the_whole_fixture_is_one_gesture(self):
        found = list(messages(frames(), bodies.FIELD, "camera", 0.3))
        self.assertEqual(1, len(found))
        message = found[0]
        self.assertEqual(("right", "camera"), (message["side"], message["frame"]))
        arm = minus(message["joints"]["right_wrist"], message["joints"]["right_shoulder"])
        self.assertLess(math.degrees(angle(arm, bodies.AIM)), 2)
        truth = [s + o for s, o in zip(bodies.body(True)[12], bodies.PLACE)]
        self.assertLess(math.dist(truth, message["joints"]["right_shoulder"]), 0.05)
        self.assertAlmostEqual(frames()[bodies.FIRST].t + 0.3, message["t"], delta=0.04)

    def test_an_arm_that_hangs_does_not_point(self):
        arms = [pointing_arm(f) for f in frames()]
        self.assertEqual([None] * 10 + ["right"] * 20 + [None] * 10, arms)

    def test_a_bent_arm_does_not_point(self):
        frame = frames()[15]
        frame.world[14][1] += 0.3
        self.assertIsNone(pointing_arm(frame))

    def test_a_hidden_arm_does_not_point(self):
        frame = frames()[15]
        frame.world[16][3] = 0.2
        self.assertIsNone(pointing_arm(frame))

    def test_another_direction_is_another_gesture(self):
        gestures, base, told = Gestures(0.1), frames()[15], 0
        for k in range(40):
            frame = Frame.of({**json.loads(json.dumps(base._asdict())), "t": k / 30})
            for joint, reach in ((14, 0.28), (16, 0.53)):
                turned = (0.6, 0.3, -0.74) if k < 20 else (-0.6, 0.3, -0.74)
                frame.world[joint][:3] = [s + reach * a for s, a in zip(frame.world[12], turned)]
            told += gestures.side(frame) is not None
        self.assertEqual(2, told)

    def test_the_place_is_exact_without_noise(self):
        focal = 1000 / 2 / math.tan(0.5)
        world = [[math.sin(k), math.cos(2 * k), math.sin(3 * k), 1] for k in range(COUNT)]
        at = (0.3, -0.2, 3.1)
        image = [[(x + at[0]) / (z + at[2]) * focal / 1000 + 0.5, (y + at[1]) / (z + at[2]) * focal / 800 + 0.5, 0, 1]
                 for x, y, z, _ in world]
        for found, true in zip(place(Frame(0, 1000, 800, image, world), 1.0), at):
            self.assertAlmostEqual(true, found, places=9)

    def test_who_is_hardly_seen_is_nowhere(self):
        frame = frames()[15]
        for point in frame.image:
            point[3] = 0.1
        with self.assertRaisesRegex(ValueError, "too little"):
            place(frame, 1.0)
        self.assertEqual([], list(messages([frame], bodies.FIELD, "camera", 0)))

    def test_a_bad_line_is_named(self):
        path = os.path.join(HERE, "test_pointing.py")
        with self.assertRaisesRegex(BadInput, r"test_pointing.py:1: expected a picture's landmarks"):
            list(recorded(path))


if __name__ == "__main__":
    unittest.main()
