#!/usr/bin/env python3
"""A simulated robot: asks what to do, does it, and reports what it did, until an object is handed over.

An act takes as long as the domain says (times --scale). What a reach comes to is for the person to say, who is asked over a
socket of their own (see sensor_sim.py), or at the keyboard with --hand keyboard. Exit code 1 if nothing was handed over.
"""
import json
import math
import time
from typing import Any, Callable, Dict

import client
from client import Bridge, zmq
from sensor_sim import HAND

PATIENCE = 10.0  # seconds that the person may take to decide


def main() -> int:
    parser = client.options(__doc__)
    parser.add_argument("--deadline-ms", type=int, default=500, metavar="MS", help="for each decision (default: 500)")
    parser.add_argument("--hand", metavar="ADDRESS", default=HAND, help="whom to offer objects to, or keyboard (default: %(default)s)")
    parser.add_argument("--acts", type=int, default=100, metavar="N", help="gives up after so many acts (default: 100)")
    parser.add_argument("--seed", type=int, metavar="N", help="for the planner (default: the bridge's own)")
    parser.add_argument("--scale", type=float, default=1.0, metavar="S", help="seconds are this much longer (default: 1)")
    given = parser.parse_args()
    if not 0 <= given.scale < math.inf:
        raise client.BadInput(f"--scale: expected a number of at least 0, got {given.scale}")
    if given.acts < 1:
        raise client.BadInput(f"--acts: expected a whole number of at least 1, got {given.acts}")
    offer = at_keyboard if given.hand == "keyboard" else to_person(given.hand)
    with client.connect(given, "robot") as bridge:
        robot = Robot(bridge, offer, given.scale)
        bridge.ask("begin", **({} if given.seed is None else {"seed": given.seed}))
        for _ in range(given.acts):
            if robot.act(bridge.ask("decide", deadline_ms=given.deadline_ms)):
                break
        end = bridge.ask("end")
        print(f"end: {end['handovers']} handed over, {end['acts']} acts", flush=True)
        return 0 if robot.handed_over else 1


class Robot:
    """Executes decisions. offer: asks the person whether they take an object."""

    def __init__(self, bridge: Bridge, offer: Callable[[str], bool], scale: float):
        welcome = bridge.hello()
        self.bridge, self.offer, self.scale = bridge, offer, scale
        self.durations, self.increments = welcome["durations"], welcome["increments"]
        self.handed_over = 0

    def act(self, decision: Dict[str, Any]) -> bool:
        """Does what was decided; whether the episode is over."""
        act, about = decision["act"], decision.get("objects", [])
        print(f"{act}({','.join(about)}){' says ' + json.dumps(decision['say']) if decision.get('say') else ''}"
              f" after {decision['ms']:.0f} ms", flush=True)
        picks = act == "PICK"
        self.bridge.acted(decision, "started")
        time.sleep(self.scale * self.durations[act] / (self.increments if picks else 1))
        if not picks:
            self.bridge.acted(decision, "completed")
            return False
        if self.bridge.ask("state")["progress"] < self.increments:
            self.bridge.acted(decision, "completed", "moving")
            return False
        taken = self.offer(about[0])
        self.handed_over += taken
        self.bridge.acted(decision, "completed", "accepted" if taken else "rejected")
        return self.bridge.ask("state")["done"]


def to_person(address: str) -> Callable[[str], bool]:
    socket = zmq.Context.instance().socket(zmq.REQ)
    socket.linger = 0
    try:
        socket.connect(address)
    except zmq.ZMQError as e:
        raise client.BadInput(f"--hand {address}: expected keyboard or an address such as {HAND} ({e})") from e

    def offer(name: str) -> bool:
        socket.send(json.dumps({"offer": name}).encode())
        if not socket.poll(PATIENCE * 1000):
            raise client.NoAnswer(f"{address}: nobody says whether they take {name}")
        return json.loads(socket.recv())["taken"]
    return offer


def at_keyboard(name: str) -> bool:
    try:
        return input(f"Do you take {name}? [y/n] ").strip().lower().startswith("y")
    except EOFError as e:
        raise client.BadInput("--hand keyboard: expected y or n, got the end of the input") from e


if __name__ == "__main__":
    client.run(main)
