"""How long the default planner takes to decide anew: best of many, in microseconds.

python benchmarks/replan.py
"""

from __future__ import annotations

import time

import numpy as np

from footfall.compilation import kernel
from footfall.support import SupportSequence
from footfall.sync.events import reconsider
from footfall.sync.planner import plan
from footfall.sync.tables import Rules, SequenceTable, rules_of
from footfall.sync.window import Window

CALLS, REPEATS = 200, 9

WALK, RUN = "R.4 D.14 L.4 D.14*", "R.2 -.14 L.2 -.14*"
KICK, JUMP = "D.35 L.75 D.45", "D.55 -.42 D.6"
SKIP, SIDE = "R.2 -.16 R.2 L.2 -.16 L.2*", "D.18 R.36 D.18 L.36*"
CASES = {
    "one action": [WALK],
    "two actions": [WALK, RUN],
    "three actions": [WALK, SIDE, RUN],
    "three, one that ends": [WALK, RUN, KICK],
    "three with flights": [SKIP, RUN, "R.18 L.2 -.12*"],
    "four actions": [WALK, RUN, KICK, JUMP],
    "eight actions": [WALK, RUN, KICK, JUMP, SKIP, SIDE, WALK, RUN],
}


@kernel
def plan_often(table: SequenceTable, window: Window, rules: Rules, calls: int) -> None:
    """Plan the same window again and again."""
    for _ in range(calls):
        plan(table, window, rules)


def microseconds(texts: list[str]) -> float:
    """Return how long one re-planning takes, the best of `REPEATS`."""
    table = SequenceTable.of([SupportSequence.parse(text) for text in texts])
    window = Window.empty(len(texts), 5)
    rules = rules_of("footfall")
    window.sequence[:] = window.age[:] = np.arange(len(texts))
    window.priority[:] = window.weight[:] = np.arange(len(texts), 0, -1)
    window.playing[:] = True
    window.phases[:, 0] = [1 if text.startswith(("R.4", "R.2 -")) else 0 for text in texts]
    window.remaining[:] = table.durations[table.first + window.phases[:, 0]]
    reconsider(table, window, rules)
    best = float("inf")
    for _ in range(REPEATS):
        start = time.perf_counter()
        plan_often(table, window, rules, CALLS)
        best = min(best, time.perf_counter() - start)
    return best / CALLS * 1e6


if __name__ == "__main__":
    for name, texts in CASES.items():
        print(f"{name:22}{microseconds(texts):8.1f} us")
