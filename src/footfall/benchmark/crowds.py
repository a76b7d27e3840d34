"""What crowds cost: by size, while weights rest and while they move, on one thread and on two."""

from __future__ import annotations

import time

import numpy as np

from footfall.benchmark.rows import Row, seconds_each
from footfall.compilation import kernel
from footfall.engine import Character, Crowd, MotionLibrary
from footfall.engine.planning import copy_window
from footfall.samples import sample
from footfall.sync.planner import plan
from footfall.sync.tables import Planner, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["DT", "crowd_rows", "mixing_crowd"]


DT = 1.0 / 60.0
"""A frame [s]."""

WARM_UP = 2.0
"""How long a crowd runs before it is measured [s]: every start has come to its full weight."""


def mixing_crowd(
    rows: int,
    actions: int,
    *,
    planner: Planner = "paper",
    threads: int = 1,
    fade: float = 0.3,
    in_step: bool = False,
) -> Crowd:
    """Return a crowd that mixes some actions; its characters are out of step unless asked for."""
    library = MotionLibrary()
    for index in range(actions):
        name = ("walk", "walk-fast", "run")[index % 3]
        library.add(f"motion {index}", *sample(name), fade_in=fade)
    crowd = Crowd(library, rows, planner=planner, threads=threads)
    random = np.random.default_rng(0)
    crowd.place(random.uniform(-100.0, 100.0, (rows, 2)), random.uniform(-3.0, 3.0, rows))
    crowd.start(0, ahead=0.0 if in_step else random.uniform(0.0, 1.0, rows))
    for action in range(1, actions):
        crowd.start(action)
    for _ in range(round(WARM_UP / DT)):
        crowd.advance(DT)
    return crowd


def _tick(crowd: Crowd, rounds: int = 60) -> float:
    """Return what one frame costs [µs a character]."""
    return 1e6 * seconds_each(lambda: crowd.advance(DT), rounds) / crowd.size


def _frames(rows: int, count: int) -> list[float]:
    """Return how long frames of a large crowd take on two threads, sorted [ms]."""
    crowd = mixing_crowd(rows, 3, threads=2)
    taken: list[float] = []
    for _ in range(count):
        start = time.perf_counter()
        crowd.advance(DT)
        taken.append(1e3 * (time.perf_counter() - start))
    return sorted(taken)


def crowd_rows() -> list[Row]:
    """Measure crowds of several sizes."""
    small, middle = _tick(mixing_crowd(1000, 3)), _tick(mixing_crowd(10_000, 3))
    crowd = mixing_crowd(10_000, 3, fade=60.0)
    fading = _tick(crowd)
    planned = _tick(mixing_crowd(1000, 3, planner="footfall"))
    fifty, thirty = _frames(50_000, 120), _frames(30_000, 200)
    large = _tick(mixing_crowd(50_000, 3), 15)
    return [
        Row("tick_1k_us", small, None, "us a character"),
        Row("tick_10k_us", middle, 0.6, "us a character"),
        Row("tick_10k_fading_us", fading, 1.0, "us a character"),
        Row("tick_1k_planner_us", planned, None, "us a character, default planner"),
        Row("frame_50k_p50_ms", fifty[len(fifty) // 2], 16.6, "ms"),
        Row("frame_30k_p99_ms", thirty[int(0.99 * len(thirty))], 16.6, "ms"),
        Row("advance_us", _advance_of_one(), 15.0, "us"),
        Row("event_us", _event(), 1.0, "us"),
        Row("replan_us", _replan(), 15.0, "us"),
        Row("bytes_per_character", _bytes(crowd), 4096.0, "bytes"),
        Row("linearity_10k", 100.0 * abs(middle / small - 1.0), 35.0, "% from 1 000"),
        Row("linearity_50k", 100.0 * abs(large / middle - 1.0), 20.0, "% from 10 000"),
    ]


def _advance_of_one() -> float:
    hero = Character(sample("walk")[0].skeleton)
    for name in ("walk", "walk-fast", "run"):
        hero.add(name, *sample(name))
        hero.start(name)
        for _ in range(60):
            hero.advance(DT)
    return 1e6 * seconds_each(lambda: hero.advance(DT), 15, 60)


def _event() -> float:
    """Return what entering a slot costs in paper mode [µs], by fitting frames with few and many.

    All characters are in step: in most frames no slot ends, in some nearly all do.
    """
    crowd = mixing_crowd(1000, 3, in_step=True)
    events: list[float] = []
    spent: list[float] = []
    for _ in range(240):
        before = int(crowd.characters["slot_index"].sum())
        start = time.process_time()
        crowd.advance(DT)
        spent.append(1e6 * (time.process_time() - start))
        events.append(float(int(crowd.characters["slot_index"].sum()) - before))
    busy = np.array(events) > 0.5 * crowd.size
    if not busy.any() or busy.all():
        return float("nan")
    apart = np.median(np.array(spent)[busy]) - np.median(np.array(spent)[~busy])
    return float(apart / np.median(np.array(events)[busy]))


@kernel
def _plan_often(table: SequenceTable, window: Window, rules: Rules, times: int) -> None:
    for _ in range(times):
        plan(table, window, rules)


def _replan() -> float:
    crowd = mixing_crowd(8, 3, planner="footfall")
    window = copy_window(crowd.characters[0], crowd.search)
    times = 50
    table, rules = crowd.shelf.table, crowd.rules
    return 1e6 * seconds_each(lambda: _plan_often(table, window, rules, times), 9) / times


def _bytes(crowd: Crowd) -> float:
    return (crowd.characters.nbytes + crowd.poses.nbytes) / crowd.size
