"""Layers: motions laid over what plays, as the difference to a pose, on parts of the upper body.

They come after the blend and before the body is placed, so that hands reach from there. A layer
stands on nothing: it takes no part in the schedule, waits for nobody and never turns the legs or
the pelvis, so no foot moves by it. It goes at its own speed; its weight fades along a smoothstep.

A joint is turned by `weight` of the turn that takes the reference to the clip, in the frame of its
parent: over the reference itself, at weight 1, comes the clip. Several lie on each other in the
order of their seats.
"""

from __future__ import annotations

import math

from footfall.arrays import SmallFloats
from footfall.compilation import inner_kernel, small_kernel
from footfall.engine.entry import Entry
from footfall.engine.layer_record import LAYERS, LEAVES, LIES, NOTHING, LayerSeat, LayerShelf
from footfall.engine.record import Character
from footfall.engine.shelf import key_at
from footfall.geometry import quaternions
from footfall.octet_memory import load, store
from footfall.octets import LANES, select, square_root
from footfall.timing import smoothstep

__all__ = ["lay_over"]

COMPLETE = 1.0 - 1e-6
"""Sums of frame times miss 1 by rounding; a fade that close to its end is over."""

SHORTEST = 1e-6
"""Length of a sum of rotations below which it says nothing: a joint is not turned then."""


@inner_kernel
def lay_over(shelf: LayerShelf, me: Character, blended: SmallFloats, dt: float) -> None:
    """Let the layers of one character go on, and lay them over its pose.

    Args:
        shelf: All layers.
        me: The character; it says whether it still has one on.
        blended: Its pose by component, shape (4 rows + 8,); rewritten.
        dt: Time step [s], >= 0.
    """
    me.layered = False
    for place in range(LAYERS):
        seat = me.layers[place]
        if seat.status == NOTHING:
            continue
        entry = shelf.entries[seat.layer]
        _go_on(entry, seat, dt)
        if seat.status == NOTHING:
            continue
        me.layered = True
        weight = _weight(seat)
        if weight > 0.0:
            _turn_joints(shelf.keys, entry, seat.time, weight, blended)


@small_kernel
def _go_on(entry: Entry, seat: LayerSeat, dt: float) -> None:
    """Let time pass for one layer; one that ends fades out so as to be gone by its end."""
    left = dt
    if not entry.cyclic and seat.status == LIES:
        until = max(entry.duration - entry.fade_out - seat.time, 0.0)
        if until <= dt:
            _fade(seat, entry.fade_in, until)
            seat.before = _weight(seat)
            seat.goal = 0.0
            seat.progress = 0.0
            seat.status = LEAVES
            left = dt - until
    _fade(seat, entry.fade_in if seat.status == LIES else entry.fade_out, left)
    if seat.status == LEAVES and seat.progress >= 1.0:
        seat.status = NOTHING
    time = seat.time + dt
    if entry.cyclic and entry.duration > 0.0:
        time -= entry.duration * math.floor(time / entry.duration)
    seat.time = time


@small_kernel
def _weight(seat: LayerSeat) -> float:
    """Return what its fade has come to: at its end exactly the goal."""
    share = smoothstep(seat.progress)
    return (1.0 - share) * seat.before + share * seat.goal


@small_kernel
def _fade(seat: LayerSeat, seconds: float, dt: float) -> None:
    """Advance a fade of so many seconds."""
    progress = seat.progress + dt / seconds if seconds > dt else 1.0
    seat.progress = progress if progress < COMPLETE else 1.0


@small_kernel
def _turn_joints(
    keys: SmallFloats, entry: Entry, time: float, weight: float, out: SmallFloats
) -> None:
    """Turn the joints of one pose, eight at a time."""
    frame, fraction, _ = key_at(entry, time)
    stride = keys.shape[1]
    rows = (stride - LANES) // 4
    before = frame * stride
    after = before + stride if fraction > 0.0 else before
    for row in range(0, rows, LANES):
        # From no turn on: as much of the turn as there is weight.
        w = 1.0 + weight * (_between(keys, before, after, row, fraction) - 1.0)
        x = weight * _between(keys, before, after, row + rows, fraction)
        y = weight * _between(keys, before, after, row + 2 * rows, fraction)
        z = weight * _between(keys, before, after, row + 3 * rows, fraction)
        length = square_root(w * w + x * x + y * y + z * z)
        turns = length > SHORTEST
        scale = select(turns, 1.0 / length, 0.0)
        pose = (
            load(out, row),
            load(out, row + rows),
            load(out, row + 2 * rows),
            load(out, row + 3 * rows),
        )
        w, x, y, z = quaternions.product(
            w * scale, x * scale, y * scale, z * scale, pose[0], pose[1], pose[2], pose[3]
        )
        store(out, row, select(turns, w, pose[0]))
        store(out, row + rows, select(turns, x, pose[1]))
        store(out, row + 2 * rows, select(turns, y, pose[2]))
        store(out, row + 3 * rows, select(turns, z, pose[3]))


@small_kernel
def _between(keys: SmallFloats, before: int, after: int, column: int, fraction: float) -> float:
    one = load(keys, before + column)
    return one + (load(keys, after + column) - one) * fraction
