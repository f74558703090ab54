#!/usr/bin/env python3
"""Pointing gestures to the bridge, from MediaPipe's landmarks of a body: a camera, pictures, or recorded landmarks.

MediaPipe's package comes without a pose model: --model names the file (a pose_landmarker .task file) for camera and pictures.
Its world landmarks have their origin between the person's hips, so the person's place is computed from the picture and the
camera's field of view. Messages are in the camera's frame (x right, y down, z away, metres); the domain file must have a
transform from it to the table under the name that --frame gives.
"""
import contextlib
import json
import math
import time
from typing import Any, Iterable, Iterator, List, Optional

import client
from client import BadInput
from pointing import Frame, Gestures, joints, place

INSTALL = "pip install -r scripts/requirements-gesture.txt and, on Debian or Ubuntu, apt-get install libgl1 libegl1 libgles2"


def main() -> int:
    parser = client.options(__doc__)
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--camera", type=int, metavar="N", help="number of a camera, 0 for the first")
    source.add_argument("--image", nargs="+", metavar="FILE", help="pictures, each a gesture of its own")
    source.add_argument("--landmarks", metavar="FILE", help="what --record wrote")
    parser.add_argument("--model", metavar="FILE", help="MediaPipe's pose model, for --camera and --image")
    parser.add_argument("--frame", default="camera", metavar="NAME", help="the domain file's name of the camera's frame (default: camera)")
    parser.add_argument("--fov", type=float, default=60, metavar="DEGREES", help="the camera's horizontal field of view (default: 60)")
    parser.add_argument("--hold", type=float, default=0.3, metavar="S", help="an arm points if it is held so long (default: 0.3)")
    parser.add_argument("--record", metavar="FILE", help="also write the landmarks to a file, a line for each picture")
    parser.add_argument("--dry-run", action="store_true", help="print the messages, send nothing")
    given = parser.parse_args()
    if not 1 <= given.fov <= 179:
        client.fail(f"--fov: expected degrees between 1 and 179, got {given.fov:g}")
    if given.landmarks is None and given.model is None:
        client.fail("expected --model with --camera or --image: a pose_landmarker .task file, which MediaPipe's package lacks")
    frames = recorded(given.landmarks) if given.landmarks else seen(given.model, given.camera, given.image)
    with contextlib.ExitStack() as open_files:
        if given.record:
            file = open_files.enter_context(open(given.record, "w", encoding="utf-8"))
            frames = kept(frames, file)
        found = messages(frames, math.radians(given.fov), given.frame, 0 if given.image else given.hold)
        if given.dry_run:
            for message in found:
                print(json.dumps(message), flush=True)
            return 0
        with client.connect(given, "mediapipe") as bridge:
            for message in found:
                if given.landmarks:
                    del message["t"]  # as if it were seen now
                reply = bridge.sensed("gesture", **message)
                print(f"{message['side']} arm points" + (f", belief {reply['belief']}" if reply else ""), flush=True)
    return 0


def messages(frames: Iterable[Frame], field_of_view: float, name: str, hold: float) -> Iterator[dict]:
    """The fields of a gesture message for each gesture in the pictures."""
    gestures = Gestures(hold)
    for frame in frames:
        side = gestures.side(frame)
        if side is not None:
            with contextlib.suppress(ValueError):  # too little is seen to tell where the person is
                yield {"joints": joints(frame, place(frame, field_of_view)), "side": side, "frame": name, "t": frame.t}


def recorded(path: str) -> Iterator[Frame]:
    """Pictures' landmarks from a file with one JSON object a line: t, width, height, image, world."""
    with open(path, "rb") as lines:
        for number, line in enumerate(lines, 1):
            try:
                yield Frame.of(json.loads(line))
            except (ValueError, KeyError, TypeError) as e:
                raise BadInput(f"{path}:{number}: expected a picture's landmarks ({e})") from e


def kept(frames: Iterable[Frame], file: Any) -> Iterator[Frame]:
    """The same pictures, written down as they come."""
    for frame in frames:
        file.write(json.dumps(frame._asdict()) + "\n")
        file.flush()
        yield frame


def seen(model: str, camera: Optional[int], images: Optional[List[str]]) -> Iterator[Frame]:
    """Pictures of a camera or of files, as MediaPipe sees them; those without a person are left out."""
    with open(model, "rb"):
        pass  # a better message than MediaPipe's, if it is missing
    mediapipe = client.need("mediapipe", INSTALL)
    vision = client.need("mediapipe.tasks.python.vision", INSTALL)
    python = client.need("mediapipe.tasks.python", INSTALL)
    mode = vision.RunningMode.IMAGE if images else vision.RunningMode.VIDEO
    settings = vision.PoseLandmarkerOptions(base_options=python.BaseOptions(model_asset_path=model), running_mode=mode)
    try:
        landmarker = vision.PoseLandmarker.create_from_options(settings)
    except (RuntimeError, ValueError) as e:
        raise BadInput(f"{model}: expected a pose model of MediaPipe ({str(e).splitlines()[0]})") from e
    with landmarker:
        for t, picture in pictures(images) if images else shots(camera or 0):
            image = mediapipe.Image(image_format=mediapipe.ImageFormat.SRGB, data=picture)
            found = landmarker.detect(image) if images else landmarker.detect_for_video(image, int(t * 1000))
            if found.pose_landmarks:
                yield Frame(t, image.width, image.height, plain(found.pose_landmarks[0]), plain(found.pose_world_landmarks[0]))


def plain(landmarks: Iterable[Any]) -> List[List[float]]:
    return [[p.x, p.y, p.z, p.visibility] for p in landmarks]


def pictures(paths: Iterable[str]) -> Iterator[Any]:
    cv2 = client.need("cv2", INSTALL)
    for path in paths:
        picture = cv2.imread(path)
        if picture is None:
            raise BadInput(f"{path}: expected a picture")
        yield time.time(), cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)


def shots(number: int) -> Iterator[Any]:
    """What a camera sees, until Ctrl-C."""
    cv2 = client.need("cv2", INSTALL)
    camera = cv2.VideoCapture(number)
    if not camera.isOpened():
        raise BadInput(f"--camera {number}: there is no such camera")
    try:
        while True:
            there, picture = camera.read()
            if not there:
                raise BadInput(f"--camera {number}: it gives no pictures any more")
            yield time.time(), cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)
    finally:
        camera.release()


if __name__ == "__main__":
    client.run(main)
