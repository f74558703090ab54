"""Makes landmarks.ndjson: 40 pictures of a person who raises the right arm, points, and lowers it, seen by a pinhole camera.

    python3 scripts/tests/bodies.py > scripts/tests/landmarks.ndjson

Computed, not filmed: so the truth is known. The noise is that of a good picture (3 mm, 1 pixel).
"""
import json
import math
import random

WIDTH, HEIGHT, FIELD = 640, 480, math.radians(60)
PLACE = (0.2, 0.1, 2.5)  # of the hips' middle in the camera's frame: 2.5 m away
AIM = (0.6, 0.3, -0.74)  # where the right arm points: to the right in the picture, down, to the camera
FIRST, LAST = 10, 30  # pictures in which it points


def body(points: bool):
    """33 world landmarks: metres from the middle of the hips, x right in the picture, y down, z away."""
    joints = [[0.0, -0.62, -0.1] for _ in range(33)]
    joints[11], joints[12] = [0.18, -0.48, 0.0], [-0.18, -0.48, 0.0]
    joints[13], joints[15], joints[19] = [0.2, -0.2, 0.02], [0.21, 0.05, 0.0], [0.21, 0.13, 0.0]
    for k, reach in ((14, 0.28), (16, 0.53), (20, 0.61)):
        hanging = [-0.2, -0.48 + reach, 0.0]
        joints[k] = [s + reach * a for s, a in zip(joints[12], AIM)] if points else hanging
    for k in range(23, 33):
        joints[k] = [0.1 if k % 2 else -0.1, 0.42 * ((k - 23) // 2), 0.02]
    return joints


def picture(k: int, chance: random.Random):
    focal = WIDTH / 2 / math.tan(FIELD / 2)
    world, image = [], []
    for x, y, z in body(FIRST <= k < LAST):
        at = [c + o for c, o in zip((x, y, z), PLACE)]
        u, v = focal * at[0] / at[2] / WIDTH + 0.5, focal * at[1] / at[2] / HEIGHT + 0.5
        seen = 0.99 if 0 <= u <= 1 and 0 <= v <= 1 else 0.1
        image.append([round(u + chance.gauss(0, 1) / WIDTH, 5), round(v + chance.gauss(0, 1) / HEIGHT, 5), 0.0, seen])
        world.append([round(c + chance.gauss(0, 0.003), 5) for c in (x, y, z)] + [seen])
    return {"t": 1763800000 + k / 30, "width": WIDTH, "height": HEIGHT, "image": image, "world": world}


if __name__ == "__main__":
    noise = random.Random(2026)
    for number in range(40):
        print(json.dumps(picture(number, noise), separators=(",", ":")))
