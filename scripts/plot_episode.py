#!/usr/bin/env python3
"""Draws one episode of a log of `handover simulate` as an SVG picture, with nothing but Python's own library.

    scripts/plot_episode.py episodes.jsonl 0 "poss:H=2,C=10" > episode.svg
"""
import html
import json
import sys

COLOURS = ["#1b6ca8", "#d1495b", "#2e933c", "#8a5a9e", "#c77d0a", "#3aa6a6", "#6b6b6b", "#a04000"]
LEFT, TOP, WIDTH, HEIGHT = 60, 70, 150, 240


def find(path, index, solver):
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            entry = json.loads(line)
            if entry.get("episode") == index and entry.get("solver") == solver:
                return entry
    fail(f"{path}: there is no episode {index} of {solver}")


def fail(problem):
    print(f"plot_episode.py: {problem}", file=sys.stderr)
    sys.exit(2)


def heard(step):
    words = " / ".join(f'"{a["transcript"]}"' for a in step.get("speech", []))
    return ", ".join(filter(None, [words, "points" if "gesture" in step else "", step.get("signal", "")]))


def act(step):
    return step["act"] + ("(" + ",".join(step["objects"]) + ")" if step.get("objects") else "")


def draw(episode):
    names = episode["steps"][0]["on_table"]
    steps = [s for s in episode["steps"] if s["on_table"] == names]  # the last one takes an object away
    flat = 1 / len(names)
    points = [([flat] * len(names), [flat] * len(names))] + [(s["belief"], s["human_belief"]) for s in steps]
    x = lambda k: LEFT + k * WIDTH
    y = lambda p: TOP + HEIGHT * (1 - p)
    width, height = x(len(episode["steps"])) + 130, TOP + HEIGHT + 60
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           f'<text x="{LEFT}" y="20" font-size="14">{html.escape(episode["solver"])}: the person wants {html.escape(episode["wanted"])}</text>',
           f'<text x="{LEFT}" y="38" fill="#555">solid: what the robot believes; dashed: what the person expects</text>']
    for p in (0, 0.5, 1):
        out.append(f'<line x1="{LEFT}" x2="{x(len(episode["steps"]))}" y1="{y(p)}" y2="{y(p)}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 8}" y="{y(p) + 4}" text-anchor="end" fill="#555">{p}</text>')
    for i, name in enumerate(names):
        for which, dash in ((0, ""), (1, ' stroke-dasharray="5 4"')):
            line = " ".join(f"{x(k)},{y(point[which][i]):.1f}" for k, point in enumerate(points))
            out.append(f'<polyline points="{line}" fill="none" stroke="{COLOURS[i % len(COLOURS)]}" stroke-width="2"{dash}/>')
        out.append(f'<text x="{x(len(episode["steps"])) + 8}" y="{TOP + 14 * i + 10}" fill="{COLOURS[i % len(COLOURS)]}">{html.escape(name)}</text>')
    for k, step in enumerate(episode["steps"]):
        middle = x(k) + WIDTH / 2
        out.append(f'<text x="{middle}" y="{TOP - 8}" text-anchor="middle">{html.escape(act(step))}</text>')
        out.append(f'<text x="{middle}" y="{TOP + HEIGHT + 22}" text-anchor="middle" fill="#555">{html.escape(heard(step))}</text>')
    return "\n".join(out + ["</svg>"])


if __name__ == "__main__":
    if len(sys.argv) != 4:
        fail("expected LOG EPISODE SOLVER > FILE, for instance episodes.jsonl 0 confirm > episode.svg")
    log, number, name = sys.argv[1:]
    if not number.isdecimal():
        fail(f"expected the number of an episode, got {number}")
    try:
        picture = draw(find(log, int(number), name))
    except OSError as e:
        fail(f"{log}: {e.strerror}")
    except (ValueError, KeyError, AttributeError, IndexError):
        fail(f"{log}: expected a log of handover simulate")
    print(picture)
