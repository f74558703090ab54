#!/usr/bin/env python3
"""A simulated person in a process of their own: sees what the robot does, speaks and points, and takes what they want or not.

Reacts to every act that the robot reports as started, with a model of its own (person.py): --human changes it, so that the
person differs from what the robot believes. Prints "ready" when it hears the bridge, then one line for each thing that it does.

Whether an offered object is taken is between person and robot, not the bridge's business: the robot asks on a REQ socket with
{"offer": "red_ball"} and is answered {"taken": true}. The robot then reports "accepted" or "rejected" to the bridge.
"""
import heapq
import itertools
import json
import math
import random
import time
from typing import Any, Callable, Dict, List, Tuple

import client
from client import Bridge, zmq
from person import DEFAULTS, Person, check, human, merged, objects, read_json, renamed

HAND = "tcp://127.0.0.1:5704"
REACTION = (0.2, 0.8)  # seconds after which a person reacts


def main() -> int:
    parser = client.options(__doc__)
    parser.add_argument("--wants", metavar="OBJECT", help="what the person wants (default: drawn)")
    parser.add_argument("--human", metavar="FILE", help="a human file, with what this person does otherwise")
    parser.add_argument("--domain", metavar="FILE", help="the person's own view of the table (default: as the bridge says)")
    parser.add_argument("--hand", metavar="ADDRESS", default=HAND, help="where objects are offered (default: %(default)s)")
    parser.add_argument("--handovers", type=int, default=1, metavar="N", help="leaves after taking so many (default: 1)")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="the same seed, the same person (default: 1)")
    parser.add_argument("--scale", type=float, default=1.0, metavar="S", help="seconds are this much longer (default: 1)")
    given = parser.parse_args()
    if not 0 < given.scale < math.inf:
        raise client.BadInput(f"--scale: expected a number above 0, got {given.scale}")
    if given.handovers < 1:
        raise client.BadInput(f"--handovers: expected a whole number of at least 1, got {given.handovers}")
    with client.connect(given, "person") as bridge:
        place = given.domain or given.bridge
        view = read_json(given.domain) if given.domain else bridge.hello()
        otherwise = human(given.human) if given.human else {}
        own = merged(view if given.domain else {"shoulder": view["shoulder"]}, otherwise)
        check(own, DEFAULTS, given.human or place)
        table = renamed(objects(view, place), otherwise, given.human)
        person = Person(table, own, random.Random(given.seed), given.wants)
        return Simulation(bridge, person, given.scale, random.Random(given.seed + 1)).run(given.hand, given.handovers)


class Simulation:
    """Moves a person by what the bridge publishes and by what the robot offers."""

    def __init__(self, bridge: Bridge, person: Person, scale: float, chance: random.Random):
        self.bridge, self.person, self.scale, self.chance = bridge, person, scale, chance
        self.due: List[Tuple[float, int, Callable[[], None]]] = []
        self.order = itertools.count()
        self.expected: Dict[str, float] = {}
        self.ready = False

    def run(self, hand: str, handovers: int) -> int:
        """Until so many objects are taken, or none is left."""
        events = self.bridge.subscribe("act", "belief", "heartbeat")
        offers = zmq.Context.instance().socket(zmq.REP)
        try:
            offers.bind(hand)
        except zmq.ZMQError as e:
            raise client.BadInput(f"--hand {hand}: expected a free address ({e})") from e
        poller = zmq.Poller()
        poller.register(events, zmq.POLLIN)
        poller.register(offers, zmq.POLLIN)
        while handovers and self.person.objects:
            wait = None if not self.due else max(0, self.due[0][0] - time.monotonic()) * 1000
            waiting = dict(poller.poll(wait))
            if offers in waiting:
                handovers -= self.offered(offers)
            event = self.bridge.next_event(0) if events in waiting else None
            if event:
                self.see(*event)
            while self.due and self.due[0][0] <= time.monotonic():
                heapq.heappop(self.due)[2]()
        offers.close(linger=1000)
        return 0

    def see(self, topic: str, event: Dict[str, Any]) -> None:
        if not self.ready:
            self.ready = True
            say(f"ready, wants {self.person.wants}")
        if topic == "belief":
            self.expected = event.get("human_belief", self.expected)
        elif topic == "act" and event["status"] == "started":
            self.due.clear()  # what was about to be said is moot
            wish = self.expected.get(self.person.wants, 0.0)
            text, at = self.person.react(event["act"], event["objects"], wish)
            if text:
                self.later(lambda: self.speak(text))
            if at:
                self.later(lambda: self.point(at))

    def later(self, what: Callable[[], None]) -> None:
        when = time.monotonic() + self.scale * self.chance.uniform(*REACTION)
        heapq.heappush(self.due, (when, next(self.order), what))

    def speak(self, text: str) -> None:
        say(f'says "{text}"')
        self.bridge.sensed("speech", text=text, t=time.time())

    def point(self, hand: Tuple[float, float, float]) -> None:
        say(f"points, hand at {hand}")
        self.bridge.push("gesture", hand=hand, shoulder=self.person.own["shoulder"], t=time.time())

    def offered(self, socket: Any) -> bool:
        try:
            name = json.loads(socket.recv())["offer"]
        except (ValueError, KeyError, TypeError):
            socket.send(b'{"error": "expected {\\"offer\\": \\"NAME\\"}"}')
            return False
        self.due.clear()
        taken = self.person.take(name)
        say(f"{'takes' if taken else 'does not take'} {name}")
        socket.send(json.dumps({"taken": taken}).encode())
        return taken


def say(line: str) -> None:
    print(line, flush=True)


if __name__ == "__main__":
    client.run(main)
