"""What an advance costs: one character with three actions, and a thousand at 60 Hz on one core.

Run as ``python benchmarks/characters.py``; exits with 1 where a budget is not met. The least of
many repetitions counts: machines are shared.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import footfall as ff

DT = 1.0 / 60.0


def library() -> tuple[ff.MotionLibrary, list[int]]:
    """Return a library of three motions that mix for as long as they run."""
    shelf = ff.MotionLibrary()
    return shelf, [shelf.add(name, *ff.sample(name)) for name in ("walk", "walk-fast", "run")]


def least(action: Callable[[], object], rounds: int, times: int) -> float:
    """Return the least mean time of an action [s] over several rounds."""
    best = float("inf")
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(times):
            action()
        best = min(best, (time.perf_counter() - start) / times)
    return best


def one_character() -> float:
    """Return what `Character.advance` takes with three actions running [µs]."""
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton)
    hero.add("walk", walk, supports)
    for name in ("walk-fast", "run"):
        hero.add(name, *ff.sample(name))
    for name in ("walk", "walk-fast", "run"):
        hero.start(name)
        for _ in range(90):
            hero.advance(DT)
    return 1e6 * least(lambda: hero.advance(DT), rounds=30, times=100)


def thousand_characters() -> float:
    """Return how many times faster than real time a thousand characters run at 60 Hz."""
    shelf, actions = library()
    crowd = ff.Crowd(shelf, size=1000)
    for action in actions:
        crowd.start(action)
        for _ in range(60):
            crowd.advance(DT)
    return DT / least(lambda: crowd.advance(DT), rounds=5, times=30)


def main() -> int:
    """Print each figure beside its budget; return 1 where one is not met."""
    advance, speed = one_character(), thousand_characters()
    print(f"advance_us            {advance:8.1f}   budget <= 60")
    print(f"thousand_x_real_time  {speed:8.1f}   budget >= 1")
    return int(advance > 60.0 or speed < 1.0)


if __name__ == "__main__":
    sys.exit(main())
