"""From landmarks of a body to pointing arms: which arm points, where the person is, when a gesture is worth a message.

Landmarks are MediaPipe's 33, by number. Image landmarks are shares of the picture's width and height. World landmarks are
metres with their origin between the hips, and axes as the camera has them: x to the picture's right, y down, z away from the
camera. So they tell directions, but not where the person is; `place` finds that from both.
"""
import math
from typing import Any, Dict, List, NamedTuple, Optional, Sequence

from person import Vector, angle, minus

NAMES = {11: "left_shoulder", 12: "right_shoulder", 13: "left_elbow", 14: "right_elbow", 15: "left_wrist", 16: "right_wrist",
         19: "left_index", 20: "right_index"}
ARMS = {"left": (11, 13, 15), "right": (12, 14, 16)}
COUNT = 33
VISIBLE = 0.5
DOWN = (0.0, 1.0, 0.0)
STRAIGHT = math.radians(40)  # an arm that points bends less than this at the elbow
HANGING = math.radians(35)  # and is further from hanging than this
TURNED = math.radians(10)  # another gesture: the arm turned further than this


class Frame(NamedTuple):
    """One picture's landmarks.

    t: Unix seconds; width, height: pixels; image, world: 33 lists of x, y, z, visibility
    """

    t: float
    width: float
    height: float
    image: List[List[float]]
    world: List[List[float]]

    @staticmethod
    def of(tree: Dict[str, Any]) -> "Frame":
        """From a line of a landmark file; ValueError if it is none."""
        frame = Frame(*(tree[f] for f in ("t", "width", "height", "image", "world")))
        for points in (frame.image, frame.world):
            if len(points) != COUNT or any(len(p) != 4 or not all(map(math.isfinite, p)) for p in points):
                raise ValueError(f"expected {COUNT} landmarks of 4 finite numbers")
        return frame


def place(frame: Frame, field_of_view: float) -> Vector:
    """Where the origin of the world landmarks is in the camera's frame (x right, y down, z away), metres.

    A pinhole camera sees X at u = f X_x / X_z; with X = world + t every visible landmark gives two equations that are linear
    in t, solved by least squares. field_of_view: horizontal, radians. ValueError if too little is seen.
    """
    focal = frame.width / 2 / math.tan(field_of_view / 2)
    rows, right = [], []
    for (u, v, _, seen), (x, y, z, _) in zip(frame.image, frame.world):
        if seen >= VISIBLE:
            a, b = (u - 0.5) * frame.width / focal, (v - 0.5) * frame.height / focal
            rows += [(1.0, 0.0, -a), (0.0, 1.0, -b)]
            right += [a * z - x, b * z - y]
    normal = [[sum(r[i] * r[j] for r in rows) for j in range(3)] for i in range(3)]
    wanted = [sum(r[i] * q for r, q in zip(rows, right)) for i in range(3)]
    whole = _determinant(normal)
    if len(rows) < 6 or abs(whole) < 1e-9:
        raise ValueError("too little of the body is seen")
    # Cramer's rule.
    t = [_determinant([[wanted[i] if j == k else normal[i][j] for j in range(3)] for i in range(3)]) / whole for k in range(3)]
    return (t[0], t[1], t[2])


def pointing_arm(frame: Frame) -> Optional[str]:
    """left or right: the arm that is stretched out, the straighter one of two; None if none is."""
    bends = {}
    for side, joints in ARMS.items():
        if all(frame.world[j][3] >= VISIBLE for j in joints):
            shoulder, elbow, wrist = (frame.world[j] for j in joints)
            bend = angle(minus(elbow, shoulder), minus(wrist, elbow))
            if bend < STRAIGHT and angle(minus(wrist, shoulder), DOWN) > HANGING:
                bends[side] = bend
    return min(bends, key=bends.__getitem__) if bends else None


def joints(frame: Frame, origin: Vector) -> Dict[str, List[float]]:
    """The visible joints of both arms by MediaPipe's names, in the camera's frame, metres."""
    return {name: [round(c + o, 4) for c, o in zip(frame.world[k][:3], origin)]
            for k, name in NAMES.items() if frame.world[k][3] >= VISIBLE}


class Gestures:
    """Lets one picture through for each gesture: the arm was held still for so long, and the gesture is not the last one.

    A camera sees the same gesture 30 times a second, and 30 messages would count as 30 independent gestures.
    """

    def __init__(self, hold: float = 0.3):
        self.hold = hold
        self._arm: Optional[Vector] = None
        self._since = 0.0
        self._told = False

    def side(self, frame: Frame) -> Optional[str]:
        """The pointing arm if this picture completes a gesture, else None."""
        side = pointing_arm(frame)
        if side is None:
            self._arm = None
            return None
        shoulder, _, wrist = (frame.world[j] for j in ARMS[side])
        arm = minus(wrist, shoulder)
        if self._arm is None or angle(arm, self._arm) > TURNED:
            self._arm, self._since, self._told = arm, frame.t, False
        if self._told or frame.t - self._since < self.hold:
            return None
        self._told = True
        return side


def _determinant(m: Sequence[Sequence[float]]) -> float:
    return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))
