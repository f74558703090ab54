"""A simulated person who wants an object: what they say, show and take, given what the robot does.

The distributions are those of the handover model (speech, answers, gestures), with parameters of the person's own, so that the
person may differ from what the robot believes of them. Nothing here knows of sockets.
"""
import copy
import json
import math
import random
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from client import BadInput

Vector = Tuple[float, float, float]

ARM = 0.6  # metres from shoulder to hand
DEFAULTS: Dict[str, Any] = {
    "tau": 1,
    "shoulder": [0.15, 1.4, 0.35],
    "pointing_origin": [0, 0, 0.3],
    "understanding": {"sigma_point": 0.1, "sigma_look": 0.162},
    "speech": {"alpha": 0.2, "surprise": 0, "answer_error": 0.01, "word_counts": [0.5, 0.3, 0.2]},
    "gesture": {"variance": 0.04, "outliers": 0.05},
    "acts": {
        "wait": {"speech_rate": 0.4, "gesture_rate": 0.3, "answer_if_match": 0.5, "answer_if_miss": 0.5},
        "look": {"speech_rate": 0.5, "gesture_rate": 0.3, "answer_if_match": 0.3, "answer_if_miss": 0.3},
        "point": {"speech_rate": 0.5, "gesture_rate": 0.3, "answer_if_match": 0.9, "answer_if_miss": 0.9},
        "ask": {"speech_rate": 0.5, "gesture_rate": 0.3, "answer_if_match": 0.95, "answer_if_miss": 0.95},
        "pick": {"speech_rate": 0.5, "gesture_rate": 0.3, "answer_if_match": 0.1, "answer_if_miss": 0.7},
    },
}


# What else a human file may say, of no use to a person who is simulated here, or read elsewhere.
OTHERS = ["objects", "perception", "tau_human", "description", "$schema"]


class Reaction(NamedTuple):
    """What a person does about an act. text: what they say; hand: metres, where they point; either may be None."""

    text: Optional[str]
    hand: Optional[Vector]


class Person:
    """Somebody who wants one of the objects.

    objects: in the form of a domain file (name, position, words); parameters: those of a domain or human file that differ from
    DEFAULTS; wants: name of an object, None to draw one
    """

    def __init__(self, objects: Sequence[Dict[str, Any]], parameters: Dict[str, Any], chance: random.Random,
                 wants: Optional[str] = None):
        self.objects = {o["name"]: o for o in objects}
        self.words = sorted({w for o in objects for w in o["words"]})
        self.own = merged(DEFAULTS, parameters)
        self.chance = chance
        if wants is not None and wants not in self.objects:
            raise BadInput(f"expected the name of an object, one of {', '.join(self.objects)}, got {wants}")
        self.wants = wants or chance.choice(list(self.objects))
        self._reference: Optional[Tuple[str, List[str]]] = None

    def react(self, act: str, about: List[str], expected: float = 0.0) -> Reaction:
        """What the person does when the robot starts an act.

        about: the act's objects; expected: how likely the person thinks that the robot will hand over what they want
        """
        others = [name for name in self.objects if name != self.wants]
        if others and self.chance.random() >= self.own["tau"]:
            self.wants = self.chance.choice(others)
        if act in ("ASK", "POINT", "LOOK"):
            self._reference = (act, about)
        elif act == "PICK":
            self._reference = None
        rates = self.own["acts"].get(act.lower(), self.own["acts"]["wait"])
        speech = self.own["speech"]
        answer = self._answer(rates, self._match(act, about))
        if answer:
            self._reference = None
        speaks = min(0.99, max(0.0, rates["speech_rate"] + speech["surprise"] * (1 - expected)))
        said = [answer] if answer else []
        if self.chance.random() < speaks:
            said.append("the " + " ".join(self._some_words()))
        hand = self._hand() if self.chance.random() < rates["gesture_rate"] else None
        return Reaction(", ".join(said) or None, hand)

    def take(self, offered: str) -> bool:
        """Whether the person takes what is offered; then it is gone, and they want another object, if one is left."""
        self._reference = None
        if offered != self.wants or offered not in self.objects:
            return False
        del self.objects[offered]
        if self.objects:
            self.wants = self.chance.choice(list(self.objects))
        return True

    def _match(self, act: str, about: List[str]) -> Optional[float]:
        """The probability that the person understands the act as a question for what they want; None if it is none."""
        if act == "WAIT":
            return None if self._reference is None else self._match(*self._reference)
        if act in ("POINT", "LOOK"):
            sigma = self.own["understanding"]["sigma_" + act.lower()]
            origin = self.own["pointing_origin"]
            aim = minus(self.objects[about[0]]["position"], origin) if about[0] in self.objects else None
            if aim is None:
                return 0.0
            seen = {name: math.exp(-angle(aim, minus(o["position"], origin)) ** 2 / (2 * sigma ** 2))
                    for name, o in self.objects.items()}
            return seen[self.wants] / sum(seen.values())
        return 1.0 if self.wants in about else 0.0

    def _answer(self, rates: Dict[str, float], match: Optional[float]) -> Optional[str]:
        if match is None:
            return None
        error = self.own["speech"]["answer_error"]
        hit, miss = match * rates["answer_if_match"], (1 - match) * rates["answer_if_miss"]
        yes, no = hit * (1 - error) + miss * error, hit * error + miss * (1 - error)
        level = self.chance.random()
        return "yes" if level < yes else "no" if level < yes + no else None

    def _some_words(self) -> List[str]:
        speech, counts = self.own["speech"], self.objects[self.wants]["words"]
        weights = [counts.get(w, 0) + speech["alpha"] for w in self.words]
        number = self.chance.choices(range(1, len(speech["word_counts"]) + 1), speech["word_counts"])[0]
        return self.chance.choices(self.words, weights, k=number)

    def _hand(self) -> Vector:
        shoulder = self.own["shoulder"]
        gesture = self.own["gesture"]
        if self.chance.random() < gesture["outliers"]:
            z, turn = self.chance.uniform(-1, 1), self.chance.uniform(0, 2 * math.pi)
            flat = math.sqrt(1 - z * z)
            direction = (flat * math.cos(turn), flat * math.sin(turn), z)
        else:
            direction = self._around(unit(minus(self.objects[self.wants]["position"], shoulder)), gesture["variance"])
        return tuple(round(s + ARM * d, 4) for s, d in zip(shoulder, direction))  # type: ignore[return-value]

    def _around(self, axis: Vector, variance: float) -> Vector:
        """A direction whose angle to the axis has a density proportional to sin(t) exp(-t^2 / (2 variance))."""
        while True:
            # A Rayleigh variate has t exp(...); thinned by sin(t) / t.
            tilt = math.sqrt(-2 * variance * math.log(1 - self.chance.random()))
            if tilt < math.pi and self.chance.random() * tilt <= math.sin(tilt):
                break
        side = unit(cross(axis, (1.0, 0.0, 0.0) if abs(axis[0]) < 0.8 else (0.0, 1.0, 0.0)))
        other = cross(axis, side)
        turn = self.chance.uniform(0, 2 * math.pi)
        return tuple(math.cos(tilt) * a + math.sin(tilt) * (math.cos(turn) * s + math.sin(turn) * o)
                     for a, s, o in zip(axis, side, other))  # type: ignore[return-value]


def merged(base: Dict[str, Any], changes: Dict[str, Any]) -> Dict[str, Any]:
    """A deep copy of a tree with some leaves changed."""
    tree = copy.deepcopy(base)
    for key, value in changes.items():
        tree[key] = merged(tree[key], value) if isinstance(value, dict) and isinstance(tree.get(key), dict) else value
    return tree


def human(path: str) -> Dict[str, Any]:
    """A human file: what this person does otherwise."""
    tree = read_json(path)
    for key in tree:
        if key not in DEFAULTS and key not in OTHERS:
            raise BadInput(f"{path}: {key}: expected one of {', '.join([*DEFAULTS, *OTHERS])}")
    return tree


def objects(view: Dict[str, Any], path: str) -> List[Dict[str, Any]]:
    """The objects of a domain, each with name, position and words."""
    found = view.get("objects")
    for k, o in enumerate(found if isinstance(found, list) and found else [None]):
        if not (_has_words(o) and _like(o.get("position"), [0.0, 0.0, 0.0])):
            raise BadInput(f"{path}: objects[{k}]: expected a name, a position of three numbers, and words with numbers")
    return found


def renamed(table: List[Dict[str, Any]], own: Dict[str, Any], path: str) -> List[Dict[str, Any]]:
    """The objects of a table with the words that a human file has for some of them."""
    words = {}
    others = own.get("objects", [])
    for k, o in enumerate(others if isinstance(others, list) else [None]):
        if not _has_words(o) or o["name"] not in [known["name"] for known in table]:
            raise BadInput(f"{path}: objects[{k}]: expected the name of an object on the table, and words with numbers")
        words[o["name"]] = o["words"]
    return [{**o, "words": words.get(o["name"], o["words"])} for o in table]


def _has_words(o: Any) -> bool:
    return (isinstance(o, dict) and isinstance(o.get("name"), str) and isinstance(o.get("words"), dict)
            and all(_like(n, 0.0) and n >= 0 for n in o["words"].values()))


def check(own: Dict[str, Any], model: Dict[str, Any], path: str, place: str = "") -> None:
    """Raises BadInput where a parameter is not of the form that it has in the model."""
    for key, value in model.items():
        if key in own and isinstance(value, dict) and isinstance(own[key], dict):
            check(own[key], value, path, f"{place}{key}.")
        elif key in own and (isinstance(value, dict) or not _like(own[key], value, any_length=key == "word_counts")):
            raise BadInput(f"{path}: {place}{key}: expected something like {json.dumps(value)}, got {json.dumps(own[key])}")


def _like(value: Any, model: Any, any_length: bool = False) -> bool:
    if isinstance(model, list):
        return isinstance(value, list) and (len(value) == len(model) or any_length and value != []) and all(_like(v, 0.0) for v in value)
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def read_json(path: str) -> Dict[str, Any]:
    """A JSON object from a file, for instance a domain or a human file."""
    try:
        with open(path, encoding="utf-8") as file:
            tree = json.load(file)
    except ValueError as e:
        raise BadInput(f"{path}: expected JSON ({e})") from e
    if not isinstance(tree, dict):
        raise BadInput(f"{path}: expected an object {{...}}")
    return tree


def minus(a: Sequence[float], b: Sequence[float]) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def unit(a: Sequence[float]) -> Vector:
    length = math.hypot(*a)
    return (a[0] / length, a[1] / length, a[2] / length)


def cross(a: Sequence[float], b: Sequence[float]) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def angle(a: Sequence[float], b: Sequence[float]) -> float:
    """Radians between two directions."""
    u, v = unit(a), unit(b)
    return math.atan2(math.hypot(*cross(u, v)), u[0] * v[0] + u[1] * v[1] + u[2] * v[2])
