#!/usr/bin/env python3
"""Shows what the robot believes and what the person expects, live: bars in a terminal, else a line for each change.

Ctrl-C ends it.
"""
import shutil
import sys
from typing import Any, Dict, List

import client

CLEAR = "\x1b[H\x1b[J"
KEPT = 8  # lines about what happened


def main() -> int:
    parser = client.options(__doc__)
    given = parser.parse_args()
    with client.connect(given, "watch") as bridge:
        view = View(bridge.hello().get("domain", ""))
        try:
            view.take("belief", bridge.ask("state"))
        except client.Refused:
            view.note("no episode yet")
        events = bridge.events("belief", "decision", "act", "error", "scene", "episode")
        shown = ""
        while True:
            now = CLEAR + view.picture(shutil.get_terminal_size().columns) if sys.stdout.isatty() else view.line()
            if now != shown:
                print(now, flush=True)
                shown = now
            view.take(*next(events))


class View:
    """What is known of an episode, as text."""

    def __init__(self, title: Any):
        self.title = title if isinstance(title, str) else title.get("name", "")
        self.robot: Dict[str, float] = {}
        self.human: Dict[str, float] = {}
        self.notes: List[str] = []

    def take(self, topic: str, event: Dict[str, Any]) -> None:
        self.robot = event.get("belief", self.robot) if isinstance(event.get("belief"), dict) else self.robot
        self.human = event.get("human_belief", self.human)
        about = f"{event.get('act', '')}({','.join(event.get('objects') or [])})" if topic in ("decision", "act") else ""
        self.note({"decision": f"decided {about} in {event.get('ms', 0):.0f} ms",
                   "act": f"{event.get('status', '')} {about}{_signal(event)}",
                   "error": f"error {event.get('code')}: {event.get('message')}" if event.get("type") != "silent"
                   else f"{event.get('source')} has been silent for long",
                   "scene": "the table changed",
                   "episode": f"episode: {event.get('event', '')}"}.get(topic, ""))

    def note(self, text: str) -> None:
        if text:
            self.notes = [*self.notes[1 - KEPT:], text]

    def line(self) -> str:
        """Both beliefs' likeliest objects, and what happened last."""
        return " | ".join([f"robot: {_best(self.robot)}", f"person: {_best(self.human)}", *self.notes[-1:]])

    def picture(self, columns: int) -> str:
        """A bar for each object in both beliefs, and what happened."""
        name = max(map(len, self.robot), default=0)
        width = max(4, (columns - name - 22) // 2)
        rows = [f"{self.title}: what the robot believes is wanted, and what the person expects to be handed", ""]
        for o, p in self.robot.items():
            h = self.human.get(o, 0.0)
            rows.append(f"{o:{name}}  {p:5.3f} {'#' * round(p * width):{width}}  {h:5.3f} {'=' * round(h * width)}")
        return "\n".join(r[:columns] for r in rows + [""] + self.notes)


def _signal(event: Dict[str, Any]) -> str:
    return "" if event.get("pick", "none") == "none" else f", {event['pick']}"


def _best(belief: Dict[str, float]) -> str:
    if not belief:
        return "-"
    name = max(belief, key=belief.__getitem__)
    return f"{name} {belief[name]:.3f}"


if __name__ == "__main__":
    client.run(main)
