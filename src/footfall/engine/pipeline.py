"""One tick of the engine. READ THIS FIRST.

Data flows down this page. A character is a crowd of one: every stage is a kernel on the record of
one row, or on a block of eight of them, which for one character is filled by an eighth.
"""

from __future__ import annotations

import math
from typing import Any

import numpy.typing as npt

from footfall.adaptation.surface_record import Ground
from footfall.arrays import SmallFloats
from footfall.compilation import inlined_kernel, lean_kernel, small_kernel
from footfall.engine.clock import pass_time
from footfall.engine.feet import locate_feet, stand_where_planted
from footfall.engine.flight import fly
from footfall.engine.landing import foresee_landings
from footfall.engine.layers import lay_over
from footfall.engine.moment import Moment
from footfall.engine.placing import STEP, aim_body, place_bodies
from footfall.engine.pose import blend_poses, move_root
from footfall.engine.record import HALF_RATE, Character
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace, offset_of
from footfall.engine.treading import keep_footprints, ride
from footfall.octet_memory import fetch_ahead
from footfall.octets import LANES
from footfall.skeleton.rig import Rig
from footfall.sync.tables import Rules

__all__ = ["LONGEST_STEP", "advance_blocks"]

LONGEST_STEP = 1.0 / 30.0
"""Longest time between two poses [s]; a longer advance is cut into equal steps."""


OFTEN_USED = offset_of("playing")
"""Bytes of a record that every frame uses: the fields before the synchronizer's window."""

LEFT_OUT = -1.0
"""Stands for the time of a row that is left out."""


@inlined_kernel
def _advance_row(
    shelf: Shelf,
    ground: Ground,
    rig: Rig,
    me: Character,
    work: Workspace,
    rules: Rules,
    dt: float,
    lane: int,
) -> None:
    """Advance one character by `dt` seconds, at most `LONGEST_STEP`."""
    # 1-3. Which phases are played together, how long they last, what time it is in each clip.
    pass_time(shelf, me, work.search, rules, dt)
    # 4. The pose of each clip at that time, and their weighted mean, free of any body; over it,
    #    without a part in any of this, what the upper body does besides.
    blend_poses(shelf, rig, me, work, lane)
    if me.layered:
        lay_over(shelf.layers, me, work.blended[lane], dt)
    moment: Moment = work.moments[0]
    fly(shelf, rig, me, moment, dt)
    # 5. The feet of that mean; where nothing plays they stand where they were planted.
    stand_where_planted(shelf, me, moment)
    locate_feet(shelf, moment, work.blended[lane])
    # 6. What carries the feet takes them along; then the way over the ground, so that the heel
    #    or toe that carries stays.
    ride(ground, me, dt)
    move_root(rig, me, moment, dt)
    # 7. Where feet will land; the footprints: what was planted is held, what is lifted is let go.
    foresee_landings(shelf, ground, rig, me, moment, work.points)
    keep_footprints(ground, rig, me, moment, dt)
    # 8. What this body's legs reach for.
    aim_body(rig, me, work, lane)
    me.fresh = me.placed = False


@small_kernel
def _time_due(me: Character, dt: float) -> float:
    """Return how much time a row has to advance now [s], or less than 0 if it leaves this out."""
    if not me.present:
        return LEFT_OUT
    if me.detail != HALF_RATE:
        return dt
    me.rests = not me.rests
    me.owed += dt
    if me.rests:
        return LEFT_OUT
    due = me.owed
    me.owed = 0.0
    return due


@lean_kernel
def advance_blocks(
    shelf: Shelf,
    ground: Ground,
    rig: Rig,
    characters: npt.NDArray[Any],
    work: Workspace,
    rules: Rules,
    poses: SmallFloats,
    dt: float,
    first: int,
    end: int,
) -> None:
    """Advance blocks of eight characters by `dt` seconds, of any length.

    Args:
        shelf: The library.
        ground: What they stand on.
        rig: Their body.
        characters: Records of `character_type`, shape (rows,).
        work: Memory to work in.
        rules: The rules of the planner.
        poses: Written: joints relative to the roots, shape (blocks, joints, 7, 8).
        dt: Time step [s], >= 0.
        first: The first block.
        end: The block after the last.
    """
    steps = max(1, math.ceil(dt / LONGEST_STEP - 1e-9))
    for block in range(first, end):
        for _ in range(steps):
            anybody = False
            for lane in range(min(LANES, characters.shape[0] - block * LANES)):
                row = block * LANES + lane
                me: Character = characters[row]
                fetch_ahead(characters, min(row + 1, characters.shape[0] - 1), OFTEN_USED)
                time = _time_due(me, dt / steps)
                work.aims[STEP, lane] = time
                if time >= 0.0:
                    anybody = True
                    _advance_row(shelf, ground, rig, me, work, rules, time, lane)
            # 8. Eight bodies at once: their lengths, their legs on their footprints.
            if anybody:
                place_bodies(rig, characters, work, poses, block)
