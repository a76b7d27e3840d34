"""One tick of the engine. READ THIS FIRST.

Data flows down this page. A character is a crowd of one: every stage is a kernel on the arrays
of one row, and a crowd is the same kernels over many rows.
"""

from __future__ import annotations

import math
from typing import Any

import numpy.typing as npt

from footfall.adaptation.surfaces import Ground
from footfall.arrays import Positions, Rotations
from footfall.compilation import inlined_kernel, kernel
from footfall.engine.clock import pass_time
from footfall.engine.feet import locate_feet, stand_where_planted
from footfall.engine.flight import fly
from footfall.engine.landing import foresee_landings
from footfall.engine.placing import place_body, write_world
from footfall.engine.pose import blend_poses, move_root
from footfall.engine.record import Character
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace
from footfall.engine.treading import keep_footprints, ride
from footfall.skeleton.rig import Rig
from footfall.sync.tables import Rules

__all__ = ["LONGEST_STEP", "advance_rows"]

LONGEST_STEP = 1.0 / 30.0
"""Longest time between two poses [s]; a longer advance is cut into equal steps."""


@inlined_kernel
def _advance_row(
    shelf: Shelf,
    ground: Ground,
    rig: Rig,
    me: Character,
    work: Workspace,
    rules: Rules,
    dt: float,
) -> None:
    """Advance one character by `dt` seconds, at most `LONGEST_STEP`."""
    # 1-3. Which phases are played together, how long they last, what time it is in each clip.
    pass_time(shelf, me, work.search, rules, dt)
    # 4. The pose of each clip at that time, and their weighted mean, free of any body.
    blend_poses(shelf, rig, me, work)
    fly(shelf, rig, me, dt)
    # 5. The feet of that mean; where nothing plays they stand where they were planted.
    stand_where_planted(shelf, me)
    locate_feet(shelf, me, work)
    # 6. What carries the feet takes them along; then the way over the ground, so that the heel
    #    or toe that carries stays.
    ride(ground, me, dt)
    move_root(shelf, rig, me, dt)
    # 7. Where feet will land; the footprints: what was planted is held, what is lifted is let go.
    foresee_landings(shelf, ground, rig, me)
    keep_footprints(ground, rig, me, dt)
    # 8. This body's lengths; the legs reach for their footprints.
    place_body(shelf, rig, me, work, dt)
    me.fresh = me.placed = False


@kernel
def advance_rows(
    shelf: Shelf,
    ground: Ground,
    rig: Rig,
    characters: npt.NDArray[Any],
    work: Workspace,
    rules: Rules,
    world_rotations: Rotations,
    world_positions: Positions,
    dt: float,
) -> None:
    """Advance every character by `dt` seconds, of any length.

    Args:
        shelf: The library.
        ground: What they stand on.
        rig: Their body.
        characters: Records of `character_type`, shape (rows,).
        work: Memory to work in.
        rules: The rules of the planner.
        world_rotations: Written: joints in the world, shape (rows, joints, 4).
        world_positions: Written: joints in the world [m], shape (rows, joints, 3).
        dt: Time step [s], >= 0.
    """
    steps = max(1, math.ceil(dt / LONGEST_STEP - 1e-9))
    for row in range(characters.shape[0]):
        me: Character = characters[row]
        for _ in range(steps):
            _advance_row(shelf, ground, rig, me, work, rules, dt / steps)
        # 9. Into the world.
        write_world(shelf, me, work, world_rotations[row], world_positions[row])
