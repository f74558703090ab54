#!/usr/bin/env python3
"""Measures a running bridge: how soon a belief moves, how punctual decisions are, and what a flood of messages does to it.

    scripts/load.py speech      from the sending of speech to the belief event, milliseconds
    scripts/load.py decide      milliseconds by which replies come after their deadline, with four sources of 30 gestures a second
    scripts/load.py stream      messages pushed, applied, shed and refused, and the bridge's memory, second by second

For decide, run a bridge that needs its whole deadline: kitchen-20 --solver poss:H=5,C=10, say.
"""
import json
import multiprocessing
import random
import time
from typing import Dict, List, Optional

import client
from client import Bridge

SHOULDER = [0.15, 1.4, 0.35]
SOURCES, HERTZ = 4, 30
DEADLINE_MS = 100
PER_EPISODE = 50


def main() -> int:
    parser = client.options(__doc__)
    parser.add_argument("what", choices=["speech", "decide", "stream"])
    parser.add_argument("--count", type=int, default=1000, metavar="N", help="utterances or decisions (default: 1000)")
    parser.add_argument("--seconds", type=float, default=60, metavar="S", help="of stream (default: 60)")
    parser.add_argument("--rate", type=int, default=10000, metavar="N", help="messages a second on stream (default: 10000)")
    parser.add_argument("--pid", type=int, metavar="PID", help="the bridge's process, to see its memory (Linux)")
    given = parser.parse_args()
    if given.count < 1:
        raise client.BadInput(f"--count: expected a whole number of at least 1, got {given.count}")
    with client.connect(given, "load") as bridge:
        if given.what == "speech":
            print(summary("speech to belief", speech(bridge, given.count)))
        elif given.what == "decide":
            print(punctuality(decide(bridge, given)))
        else:
            stream(bridge, given.seconds, given.rate, given.pid)
    return 0


def summary(what: str, ms: List[float]) -> str:
    ms = sorted(ms)
    at = lambda q: ms[min(len(ms) - 1, int(q * len(ms)))]
    return f"{what}: p50 {at(0.5):.2f} ms, p99 {at(0.99):.2f} ms, largest {ms[-1]:.2f} ms, n = {len(ms)}"


def punctuality(late: List[float]) -> str:
    """Of milliseconds by which replies came late, 0 for those that did not."""
    count = sum(ms > 0 for ms in late)
    if count == 0:
        return f"none of {len(late)} replies came after its deadline"
    return summary(f"{count} of {len(late)} replies came after their deadline (the others count as 0 ms)", late)


def speech(bridge: Bridge, count: int) -> List[float]:
    """Milliseconds from before an utterance is sent until the event with the belief after it is there."""
    bridge.subscribe("belief", "heartbeat")
    bridge.next_event()
    words = sorted({w for o in bridge.hello()["objects"] for w in o["words"]})
    taken = []
    for k in range(count):
        if k % PER_EPISODE == 0:
            bridge.ask("begin")
        start = time.perf_counter()
        version = bridge.ask("speech", text="the " + words[k % len(words)])["belief"]
        while True:
            got = bridge.next_event(10)
            if got is None:
                raise client.NoAnswer(f"no event tells of belief {version}")
            if got[0] == "belief" and got[1]["belief_version"] == version:
                break
        taken.append((time.perf_counter() - start) * 1000)
        time.sleep(0.002)
    return taken


def decide(bridge: Bridge, given) -> List[float]:
    """Milliseconds by which replies came later than their deadline; 0 for those that came before it."""
    bridge.ask("begin")  # else the gestures are refused
    stop = multiprocessing.get_context("spawn").Event()
    sensors = [multiprocessing.get_context("spawn").Process(target=gestures, args=(given.bridge, f"kinect-{k}", stop), daemon=True)
               for k in range(SOURCES)]
    for sensor in sensors:
        sensor.start()
    time.sleep(2)
    late = []
    for _ in range(given.count):
        bridge.ask("begin")  # where nothing is known yet, planning takes longest
        start = time.perf_counter()
        bridge.ask("decide", deadline_ms=DEADLINE_MS)
        late.append(max(0.0, (time.perf_counter() - start) * 1000 - DEADLINE_MS))
    stop.set()
    for sensor in sensors:
        sensor.join(10)
    return late


def gestures(address: str, source: str, stop) -> None:
    """A process that pushes gestures until it is told to stop."""
    chance = random.Random(source)
    with Bridge(address, source=source) as bridge:
        due = time.monotonic()
        while not stop.is_set():
            bridge.push("gesture", shoulder=SHOULDER, hand=hand(chance))
            due += 1 / HERTZ
            time.sleep(max(0.0, due - time.monotonic()))


def hand(chance: random.Random) -> List[float]:
    return [round(chance.uniform(-0.3, 0.6), 3), 0.9, 0.1]


def stream(bridge: Bridge, seconds: float, rate: int, pid: Optional[int]) -> None:
    """Pushes at a rate, and accounts for every message at the end."""
    bridge.timeout = 60  # it may be behind
    bridge.ask("begin")
    chance = random.Random(1)
    before = counters(bridge)
    start, sent = time.monotonic(), 0
    next_line = 1.0
    while (now := time.monotonic() - start) < seconds:
        for _ in range(min(int(now * rate) - sent, rate // 10)):
            final = sent % 100 == 0
            queued = bridge.push("speech", text="the red one") if final else bridge.push("gesture", shoulder=SHOULDER, hand=hand(chance))
            if not queued:
                time.sleep(0.001)
                break
            sent += 1
        if now >= next_line:
            next_line += max(1.0, seconds / 20)
            print(f"{now:5.1f} s: sent {sent}, {memory(pid)}", flush=True)
        time.sleep(0.001)
    took = time.monotonic() - start
    while True:
        done = {k: v - before.get(k, 0) for k, v in counters(bridge).items()}
        accounted = done.get("applied", 0) + done.get("shed", 0) + done.get("errors", 0)
        if accounted >= sent or time.monotonic() - start > took + 60:
            break
        time.sleep(0.2)
    print(f"sent {sent} in {took:.1f} s ({sent / took:.0f} a second), accounted for after {time.monotonic() - start:.1f} s: "
          f"{accounted - sent:+d}; {json.dumps(done)}; {memory(pid)}")


def counters(bridge: Bridge) -> Dict[str, int]:
    return bridge.ask("state")["counters"]


def memory(pid: Optional[int]) -> str:
    """Resident memory of a process."""
    if pid is None:
        return "memory unknown without --pid"
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return next(f"{int(line.split()[1]) // 1024} MiB" for line in status if line.startswith("VmRSS"))


if __name__ == "__main__":
    client.run(main)
