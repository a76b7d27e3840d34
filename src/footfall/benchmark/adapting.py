"""What adaptation costs beside the rest of a tick: footprints, ground, and legs that reach."""

from __future__ import annotations

import math
import statistics
import time

import numpy as np

from footfall.adaptation import AnyGround, HeightField, Plane, Stairs
from footfall.arrays import SmallFloats
from footfall.benchmark.rows import Row
from footfall.compilation import lean_kernel
from footfall.engine import Crowd, MotionLibrary
from footfall.engine.placing import reach_footprints
from footfall.engine.state import Workspace, new_workspace
from footfall.samples import sample
from footfall.skeleton.rig import Rig

__all__ = ["GROUNDS", "adaptation_rows", "adaptation_shares"]

DT = 1.0 / 60.0
"""A frame [s]."""

SIZE = 512
"""Characters of a crowd."""

ROUNDS = 60
"""Frames that are measured of each crowd, in turn."""


def _hills() -> HeightField:
    x, z = np.meshgrid(np.arange(-120.0, 120.0, 0.25), np.arange(-120.0, 120.0, 0.25))
    return HeightField(0.12 * np.sin(1.7 * x + 0.4) * np.cos(2.1 * z), 0.25)


GROUNDS: dict[str, AnyGround] = {
    "level": Plane(),
    "slope": Plane(0.0, (0.0, math.tan(math.radians(15.0)))),
    "hills": _hills(),
    "stairs": Stairs((0.0, -120.0, -120.0), 800, width=240.0),
}
"""Where a crowd walks about."""


def adaptation_rows() -> list[Row]:
    """Measure what adaptation costs, as a share of the rest of a tick."""
    shares = adaptation_shares()
    return [
        Row(f"adaptation_{name}", 100.0 * share, 100.0, "% of the rest of a tick")
        for name, share in shares.items()
    ]


def adaptation_shares() -> dict[str, float]:
    """Return what adaptation costs on each of `GROUNDS` over what the rest of a tick costs.

    Adaptation is what a tick costs more than one without footprints on level ground, and what the
    legs take to reach: that is done for eight bodies at once whether it is needed or not.
    """
    bare = _crowd(Plane(), footprints=False)
    crowds = {name: _crowd(ground) for name, ground in GROUNDS.items()}
    taken: dict[str, list[float]] = {name: [] for name in ("bare", "reach", *crowds)}
    work = new_workspace(bare.skeleton.count)
    for _ in range(ROUNDS):
        for name, crowd in (("bare", bare), *crowds.items()):
            start = time.thread_time()
            crowd.advance(DT)
            taken[name].append(time.thread_time() - start)
        start = time.thread_time()
        _reach_all(bare.rig, work, bare.poses.copy())
        taken["reach"].append(time.thread_time() - start)
    costs = {name: statistics.median(times) for name, times in taken.items()}
    rest = costs["bare"] - costs["reach"]
    return {name: (costs[name] - rest) / rest for name in crowds}


def _crowd(ground: AnyGround, *, footprints: bool = True) -> Crowd:
    library = MotionLibrary()
    for name in ("walk", "walk-fast", "run"):
        library.add(name, *sample(name))
    crowd = Crowd(library, SIZE, ground=ground, footprints=footprints, threads=1)
    random = np.random.default_rng(0)
    crowd.place(random.uniform(-80.0, 80.0, (SIZE, 2)), random.uniform(-3.0, 3.0, SIZE))
    crowd.start(0, ahead=random.uniform(0.0, 1.0, SIZE))
    for action in (1, 2):
        crowd.start(action)
    for _ in range(round(1.5 / DT)):
        crowd.advance(DT)
    return crowd


@lean_kernel
def _reach_all(rig: Rig, work: Workspace, poses: SmallFloats) -> None:
    """Let the legs of a whole crowd reach, all of them."""
    work.aims[:] = 1.0
    for block in range(poses.shape[0]):
        reach_footprints(rig, work, poses, block)
