"""A fixed piece of work, three times over: what a machine does with it tells how fast it is.

For each character three poses are sampled and mixed by body part, all joints placed, and both
legs reach for a point: the work that animation runtimes are compared by. Once with the engine's
own kernels, eight characters at once; once in a kernel, one character after the other; once in
plain NumPy, all characters at once.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Indices, Positions, SmallFloats
from footfall.blending import Layers, blend_layers
from footfall.compilation import lean_kernel
from footfall.engine import MotionLibrary
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace, new_workspace
from footfall.octet_memory import load, transpose
from footfall.octets import LANES
from footfall.samples import sample
from footfall.skeleton import BodyPart
from footfall.skeleton.octet_poses import PLACEMENT, place_chains, reach_ankles
from footfall.skeleton.rig import Rig

__all__ = ["LAYERS", "Task", "new_task", "placed_joints", "work_in_blocks"]

LAYERS = 3
"""How many poses are mixed."""


class Task(NamedTuple):
    """What is to be done, for some characters."""

    keys: SmallFloats
    """Normalized poses by component, shape (frames, 4 rows + 8)."""

    rig: Rig
    """The body."""

    frames: Indices
    """The frame before, shape (rows, layers)."""

    fractions: SmallFloats
    """How far the next one is, shape (rows, layers)."""

    weights: SmallFloats
    """Weight of each on each body part, shape (rows, layers, parts)."""

    aims: SmallFloats
    """Pelvis' height and both ankles, relative to the root [m], shape (rows, 7)."""

    poses: SmallFloats
    """Written: shape (blocks, joints, 7, 8)."""


def new_task(rows: int, seed: int = 1) -> Task:
    """Return the work for so many characters, a multiple of 8: the same for the same seed."""
    library = MotionLibrary()
    for name in ("walk", "run", "walk-fast", "jump"):
        library.add(name, *sample(name))
    shelf: Shelf = library.shelf()
    random = np.random.default_rng(seed)
    rig, shape = library.rig(), (rows, LAYERS)
    weights = random.uniform(0.2, 1.0, (*shape, len(BodyPart)))
    aims = np.array([0.92, 0.1, 0.12, 0.0, -0.1, 0.12, 0.0])
    aims = aims + random.normal(0.0, 0.04, (rows, 7)) * np.array([0, 1, 1, 1, 1, 1, 1])
    return Task(
        shelf.keys,
        rig,
        random.integers(0, len(shelf.keys) - 2, shape),
        random.uniform(0.0, 1.0, shape).astype(np.float32),
        (weights / weights.sum(axis=1, keepdims=True)).astype(np.float32),
        aims.astype(np.float32),
        np.zeros((rows // LANES, len(rig.parents), PLACEMENT, LANES), dtype=np.float32),
    )


def work_in_blocks(task: Task) -> None:
    """Do it with the engine's own kernels, eight characters at once, on one thread."""
    _work_in_blocks(task, _workspace(len(task.rig.parents)))


_WORKSPACES: dict[int, Workspace] = {}


def _workspace(joints: int) -> Workspace:
    if joints not in _WORKSPACES:
        _WORKSPACES[joints] = new_workspace(joints)
    return _WORKSPACES[joints]


@lean_kernel
def _work_in_blocks(task: Task, work: Workspace) -> None:
    stride = work.blended.shape[1]
    for block in range(task.poses.shape[0]):
        for lane in range(LANES):
            row = block * LANES + lane
            _list_layers(task, row, work.layers)
            out = work.blended[lane]
            blend_layers(task.keys, work.layers, LAYERS, task.rig.part_masks, out)
            for i in range(7):
                work.aims[i, lane] = task.aims[row, i]
        for row in range(0, stride - LANES, LANES):
            transpose(work.blended, row, stride, work.local, row * LANES)
        height = load(work.aims, 0)
        place_chains(task.rig, work.local, height, task.poses, block)
        for side in range(2):
            at = (1 + 3 * side) * LANES
            ankle = (
                load(work.aims, at),
                load(work.aims, at + LANES),
                load(work.aims, at + 2 * LANES),
            )
            everybody = height > 0.0
            reach_ankles(task.rig, side, work.local, ankle, everybody, task.poses, block)


@lean_kernel
def _list_layers(task: Task, row: int, layers: Layers) -> None:
    for layer in range(LAYERS):
        frame = task.frames[row, layer]
        layers.frames[layer], layers.after[layer] = frame, frame + 1
        layers.fractions[layer] = task.fractions[row, layer]
        layers.whole[layer] = False
        for part in range(task.weights.shape[2]):
            layers.weights[layer, part] = task.weights[row, layer, part]


def placed_joints(task: Task) -> Positions:
    """Return where `work_in_blocks` has put every joint [m], shape (rows, joints, 3)."""
    blocks, joints = task.poses.shape[:2]
    rows: Floats = task.poses[:, :, 4:].transpose(0, 3, 1, 2).astype(np.float64)
    return rows.reshape(blocks * LANES, joints, 3)
