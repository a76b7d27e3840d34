"""An hour in the life of a crowd: random commands, and what must still hold at its end.

`SOAK_SECONDS` in the environment makes it shorter or longer; with `-s` it prints its figures.
"""

from __future__ import annotations

import os
import time
import tracemalloc
from array import array
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest

import footfall as ff
from footfall.arrays import Positions, Rotations
from footfall.engine.placing import world_poses_of
from footfall.octets import LANES
from footfall.report.contract import contract_of
from footfall.report.trace import Trace

SECONDS = float(os.environ.get("SOAK_SECONDS", "3600"))
ROWS = 2000
FPS = 30
"""The longest step that the engine takes at once: every frame is one tick of every character, and
an hour has half as many of them as at 60."""

COMMANDED = 8
"""How many frames lie between two rounds of commands."""

SAMPLED = LANES
"""How many characters are recorded: those of the first block, from the first frame to the last."""

NAMES = ("walk", "run", "kick", "punch", "walk-fast")
CONFLICT = int(ff.Support.CONFLICT)


def command(crowd: ff.Crowd, random: np.random.Generator) -> None:
    """Tell about one in twenty to start, stop or change something."""
    rows = np.flatnonzero(random.random(ROWS) < 0.05)
    action, kind = int(random.integers(len(NAMES))), random.random()
    if kind < 0.6:
        crowd.start(action, rows, patience=3.0, late="mute")
    elif kind < 0.9:
        crowd.stop(action, rows)
    else:
        crowd.set_priority(action, float(random.uniform(0.5, 2.0)), rows)


@dataclass
class Minute:
    """The sampled characters during a minute."""

    positions: list[Positions] = field(default_factory=list[Positions])
    rotations: list[Rotations] = field(default_factory=list[Rotations])
    supports: list[Any] = field(default_factory=list[Any])

    def keep(self, crowd: ff.Crowd) -> None:
        joints = crowd.skeleton.count
        rotations, positions = np.empty((SAMPLED, joints, 4)), np.empty((SAMPLED, joints, 3))
        blocks = SAMPLED // LANES
        world_poses_of(crowd.characters[:SAMPLED], crowd.poses[:blocks], rotations, positions)
        self.positions.append(positions)
        self.rotations.append(rotations)
        self.supports.append(crowd.supports[:SAMPLED].copy())

    def drifts(self, crowd: ff.Crowd) -> list[float]:
        """Return how far the carrying point of each support span strayed [mm]."""
        positions, rotations = np.array(self.positions), np.array(self.rotations)
        supports = np.array(self.supports)
        found: list[float] = []
        for row in range(SAMPLED):
            trace = Trace(
                positions[:, row],
                rotations[:, row],
                crowd.library.anatomy,
                float(FPS),
                supports[:, row],
            )
            found += [span.drift for span in contract_of(trace, crowd.skeleton)]
        return found


def resident() -> float:
    """Return how much memory this process has [MB]; 0 where the system does not tell."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6
    except OSError:
        return 0.0


@pytest.mark.full
def test_a_long_time_of_random_commands_leaves_everything_sound() -> None:
    library = ff.MotionLibrary()
    for name in NAMES:
        library.add(name, *ff.sample(name))
    crowd, random = ff.Crowd(library, ROWS), np.random.default_rng(5)
    minute, drifts = Minute(), array("f")
    memory, sizes, worst = list[int](), list[float](), 0.0
    frames, ticked = round(SECONDS * FPS), 0.0
    tracemalloc.start()
    try:
        for frame in range(frames):
            begun = time.process_time()
            if frame % COMMANDED == 0:
                command(crowd, random)
            crowd.advance(1.0 / FPS)
            ticked += time.process_time() - begun
            assert (crowd.supports != CONFLICT).all()
            minute.keep(crowd)
            if frame % FPS == 0:
                assert np.isfinite(crowd.poses).all()
                off = np.abs(crowd.characters["clock"] - (frame + 1) / FPS)
                worst = max(worst, float(off.max()))
            if frame % (60 * FPS) == 60 * FPS - 1 or frame == frames - 1:
                assert np.isfinite(crowd.world_positions).all()
                drifts.extend(minute.drifts(crowd))
                minute = Minute()
                memory.append(tracemalloc.get_traced_memory()[0])
                sizes.append(resident())
                print(
                    f"{(frame + 1) / FPS:6.0f} s: {memory[-1] / 1e6:.2f} MB traced, "
                    f"{sizes[-1]:.0f} MB resident, {ticked / (frame + 1) / ROWS * 1e6:.2f} µs a "
                    f"character and frame, clocks off by {worst:.1e} s, drift of {len(drifts)} "
                    f"spans p50 {np.median(drifts):.2f} p95 {np.percentile(drifts, 95.0):.2f} "
                    f"max {max(drifts):.1f} mm",
                    flush=True,
                )
    finally:
        tracemalloc.stop()
    assert worst < 1e-6
    assert max(memory[1:]) - min(memory[1:]) < 1 << 20
    assert np.percentile(drifts, 95.0) <= 5.0
