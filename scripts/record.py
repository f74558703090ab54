#!/usr/bin/env python3
"""Writes what the bridge publishes as JSON lines: {"received": seconds, "topic": "belief", "event": {...}}.

Each line is flushed as it comes; Ctrl-C ends the recording.
"""
import json
import sys
import time
from contextlib import ExitStack

import client


def main() -> int:
    parser = client.options(__doc__)
    parser.add_argument("--topic", action="append", default=[],
                        help="only this one (repeatable): " + ", ".join(client.TOPICS))
    parser.add_argument("--out", metavar="FILE", help="append to this file (default: standard output)")
    parser.add_argument("--seconds", type=float, metavar="S", help="end by itself after so long")
    given = parser.parse_args()
    for topic in given.topic:
        if topic not in client.TOPICS:
            raise client.BadInput(f"--topic: expected one of {', '.join(client.TOPICS)}, got {topic}")
    with ExitStack() as stack:
        out = stack.enter_context(open(given.out, "a", encoding="utf-8")) if given.out else sys.stdout
        bridge = stack.enter_context(client.connect(given, "record"))
        bridge.subscribe(*given.topic)
        until = None if given.seconds is None else time.monotonic() + given.seconds
        while until is None or time.monotonic() < until:
            got = bridge.next_event(None if until is None else max(0.0, until - time.monotonic()))
            if got is not None:
                out.write(json.dumps({"received": time.time(), "topic": got[0], "event": got[1]}) + "\n")
                out.flush()
    return 0


if __name__ == "__main__":
    client.run(main)
