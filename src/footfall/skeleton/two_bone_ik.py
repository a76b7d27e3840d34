"""The analytic limb: two bones that reach for a point, softly where it is far.

Nothing here asks which limb it is. The bend stays in the plane it is in; only where the limb is
so straight that there is no plane does the hint decide.
"""

from __future__ import annotations

import math

from footfall.arrays import Positions, Rotations
from footfall.compilation import kernel
from footfall.geometry import quaternions

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

__all__ = ["LONGEST_REACH", "SOFT_REACH", "reach_point", "softened_reach", "turn_about"]

SOFT_REACH = 0.985
"""Extension (share of the limb's length) beyond which a target is approached softly, unless
the limb is already straighter than that."""

LONGEST_REACH = 0.9995
"""Extension that is never exceeded by reaching, since a perfectly straight limb has no bending
plane; one that is straighter already stays as straight."""

_HINT_SHARE = 0.02
"""Greatest pull of the hint on the bending direction; it decides below one degree of bend."""

_HINT_BEND = 0.05
"""Bend (sine of the upper bone's angle to the limb's line) beyond which the hint is silent."""

_HINT_MOVE = 0.01
"""Move of the end [m] below which the hint fades away: a limb that stays put stays as it is."""


@kernel
def softened_reach(distance: float, length: float, present: float) -> float:
    """Return how far a limb extends for a target at this distance.

    The distance itself up to the soft limit, then ever less, never beyond `LONGEST_REACH` nor
    what the limb has already: it approaches full extension without snapping into it.

    Args:
        distance: From the limb's start to its target [m].
        length: Of both bones together [m].
        present: The limb's extension before [m]: a limb that is already straight may stay so.
    """
    longest = min(max(LONGEST_REACH * length, present), length)
    start = min(max(SOFT_REACH * length, present), longest)
    room = longest - start
    if distance <= start:
        return distance
    if room <= 1e-9 * length:
        return longest
    return start + room * (1.0 - math.exp(-(distance - start) / room))


@kernel
def _bent_length(upper: float, lower: float, distance: float) -> float:
    """Return how far along the line to the target the middle joint stands [m]."""
    return (upper * upper + distance * distance - lower * lower) / (2.0 * distance)


@kernel
def _bending_direction(upper: Vector, line: Vector, hint: Vector, moved: float) -> Vector:
    """Return the unit direction across a limb's line in which its middle joint stands."""
    along = upper[0] * line[0] + upper[1] * line[1] + upper[2] * line[2]
    px = upper[0] - along * line[0]
    py = upper[1] - along * line[1]
    pz = upper[2] - along * line[2]
    across = math.sqrt(px * px + py * py + pz * pz)
    pull = _HINT_SHARE * max(0.0, 1.0 - across / _HINT_BEND) * min(1.0, moved / _HINT_MOVE)
    along = hint[0] * line[0] + hint[1] * line[1] + hint[2] * line[2]
    px += pull * (hint[0] - along * line[0])
    py += pull * (hint[1] - along * line[1])
    pz += pull * (hint[2] - along * line[2])
    across = math.sqrt(px * px + py * py + pz * pz)
    if across < 1e-9:
        px, py, pz = hint[0] - along * line[0], hint[1] - along * line[1], hint[2] - along * line[2]
        across = math.sqrt(px * px + py * py + pz * pz)
    if across < 1e-9:
        px, py, pz = -line[1], line[0], 0.0
        if line[0] * line[0] + line[1] * line[1] < 1e-6:
            px, py, pz = 1.0, 0.0, 0.0
        across = math.sqrt(px * px + py * py + pz * pz)
    return px / across, py / across, pz / across


@kernel
def reach_point(
    start: Vector, middle: Vector, end: Vector, target: Vector, hint: Vector
) -> tuple[Quaternion, Quaternion, Vector, Vector]:
    """Turn both bones of a limb so that its end reaches for a target.

    Args:
        start: The limb's fixed joint: a hip [m].
        middle: Its bending joint: a knee [m].
        end: Its end: an ankle [m].
        target: Where the end should be [m].
        hint: The direction in which the middle joint bends where the limb is straight.

    Returns:
        The rotations (wxyz) that turn the upper and the lower bone from where they were, both
        in the frame of the arguments; the new middle joint [m]; the new end [m]. Two limbs of
        zero length, or a target on the start, leave the limb as it is.
    """
    ux, uy, uz = middle[0] - start[0], middle[1] - start[1], middle[2] - start[2]
    lx, ly, lz = end[0] - middle[0], end[1] - middle[1], end[2] - middle[2]
    ex, ey, ez = end[0] - start[0], end[1] - start[1], end[2] - start[2]
    tx, ty, tz = target[0] - start[0], target[1] - start[1], target[2] - start[2]
    upper = math.sqrt(ux * ux + uy * uy + uz * uz)
    lower = math.sqrt(lx * lx + ly * ly + lz * lz)
    present = math.sqrt(ex * ex + ey * ey + ez * ez)
    distance = math.sqrt(tx * tx + ty * ty + tz * tz)
    none = (1.0, 0.0, 0.0, 0.0)
    if min(upper, lower, present, distance) < 1e-9:
        return none, none, middle, end
    reach = softened_reach(distance, upper + lower, present)
    reach = max(reach, abs(upper - lower) + 1e-6 * (upper + lower))
    dx, dy, dz = tx / distance, ty / distance, tz / distance
    sw, sx, sy, sz = quaternions.between(ex, ey, ez, tx, ty, tz)
    gx, gy, gz = quaternions.rotate(sw, sx, sy, sz, ux / upper, uy / upper, uz / upper)
    moved = math.sqrt((tx - ex) ** 2 + (ty - ey) ** 2 + (tz - ez) ** 2)
    px, py, pz = _bending_direction((gx, gy, gz), (dx, dy, dz), hint, moved)
    bent = _bent_length(upper, lower, reach)
    bent = min(max(bent, -upper), upper)
    height = math.sqrt(max(upper * upper - bent * bent, 0.0))
    mx, my, mz = bent * dx + height * px, bent * dy + height * py, bent * dz + height * pz
    uw, vx, vy, vz = quaternions.between(gx, gy, gz, mx, my, mz)
    upper_turn = quaternions.product(uw, vx, vy, vz, sw, sx, sy, sz)
    gx, gy, gz = quaternions.rotate(sw, sx, sy, sz, lx, ly, lz)
    nx, ny, nz = reach * dx - mx, reach * dy - my, reach * dz - mz
    lw, vx, vy, vz = quaternions.between(gx, gy, gz, nx, ny, nz)
    lower_turn = quaternions.product(lw, vx, vy, vz, sw, sx, sy, sz)
    return (
        upper_turn,
        lower_turn,
        (start[0] + mx, start[1] + my, start[2] + mz),
        (start[0] + reach * dx, start[1] + reach * dy, start[2] + reach * dz),
    )


@kernel
def turn_about(
    joint: int,
    turn: Quaternion,
    pivot: Vector,
    new_pivot: Vector,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Turn a joint about a pivot, which itself moves.

    Args:
        joint: Which joint.
        turn: How far it is turned.
        pivot: About what [m].
        new_pivot: Where that comes to be [m].
        rotations: All joints, shape (joints, 4); this one's is rewritten.
        positions: All joints [m], shape (joints, 3); likewise.
    """
    x, y, z = quaternions.rotate(
        turn[0],
        turn[1],
        turn[2],
        turn[3],
        positions[joint, 0] - pivot[0],
        positions[joint, 1] - pivot[1],
        positions[joint, 2] - pivot[2],
    )
    positions[joint, 0] = new_pivot[0] + x
    positions[joint, 1] = new_pivot[1] + y
    positions[joint, 2] = new_pivot[2] + z
    q = rotations[joint]
    q[0], q[1], q[2], q[3] = quaternions.product(
        turn[0], turn[1], turn[2], turn[3], q[0], q[1], q[2], q[3]
    )
