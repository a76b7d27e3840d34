"""The analytic limb: two bones that reach for a point, softly where it is far.

Nothing here asks which limb it is, and nothing branches: the same source serves one limb and
eight at once (`footfall.octets`). The bend stays in the plane it is in; only where the limb is
so straight that there is no plane does the hint decide.
"""

from __future__ import annotations

from footfall.arrays import Positions, Rotations
from footfall.compilation import kernel, small_kernel
from footfall.geometry import quaternions
from footfall.octets import exponential, greater, select, smaller, square_root

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

__all__ = ["LONGEST_REACH", "SOFT_REACH", "reach_point", "softened_reach", "turn_about"]

SOFT_REACH = 0.985
"""Extension (share of the limb's length) beyond which a target is approached softly, unless
the limb is already straighter than that."""

LONGEST_REACH = 0.9995
"""Extension that is never exceeded by reaching, since a perfectly straight limb has no bending
plane; one that is straighter already stays as straight."""

STRAIGHT = 1e-9
"""Distance from a limb's line below which its middle joint is on it."""

_HINT_SHARE = 0.02
"""Greatest pull of the hint on the bending direction; it decides below one degree of bend."""

_HINT_BEND = 0.05
"""Bend (sine of the upper bone's angle to the limb's line) beyond which the hint is silent."""

_HINT_MOVE = 0.01
"""Move of the end [m] below which the hint fades away: a limb that stays put stays as it is."""


@small_kernel
def softened_reach(distance: float, length: float, present: float) -> float:
    """Return how far a limb extends for a target at this distance.

    The distance itself up to the soft limit, then ever less, never beyond `LONGEST_REACH` nor
    what the limb has already: it approaches full extension without snapping into it.

    Args:
        distance: From the limb's start to its target [m].
        length: Of both bones together [m].
        present: The limb's extension before [m]: a limb that is already straight may stay so.
    """
    longest = smaller(greater(LONGEST_REACH * length, present), length)
    start = smaller(greater(SOFT_REACH * length, present), longest)
    room = longest - start
    none = room <= 1e-9 * length
    beyond = greater(distance - start, 0.0) / select(none, 1.0, room)
    soft = select(none, longest, start + room * (1.0 - exponential(-beyond)))
    return select(distance <= start, distance, soft)


@small_kernel
def _bent_length(upper: float, lower: float, distance: float) -> float:
    """Return how far along the line to the target the middle joint stands [m]."""
    return (upper * upper + distance * distance - lower * lower) / (2.0 * distance)


@small_kernel
def _bending_direction(upper: Vector, line: Vector, hint: Vector, moved: float) -> Vector:
    """Return the unit direction across a limb's line in which its middle joint stands."""
    px, py, pz, across = _across(upper, line)
    hx, hy, hz, hint_across = _across(hint, line)
    bend = greater(0.0, 1.0 - across / _HINT_BEND)
    pull = _HINT_SHARE * bend * smaller(1.0, moved / _HINT_MOVE)
    px, py, pz = px + pull * hx, py + pull * hy, pz + pull * hz
    across = square_root(px * px + py * py + pz * pz)
    # A limb that is straight and whose hint lies along it bends anywhere across it.
    flat = line[0] * line[0] + line[1] * line[1] < 1e-6
    ox, oy = select(flat, 1.0, -line[1]), select(flat, 0.0, line[0])
    lost = hint_across < STRAIGHT
    hx, hy, hz = select(lost, ox, hx), select(lost, oy, hy), select(lost, 0.0, hz)
    straight = across < STRAIGHT
    px, py, pz = select(straight, hx, px), select(straight, hy, py), select(straight, hz, pz)
    across = square_root(px * px + py * py + pz * pz)
    return px / across, py / across, pz / across


@small_kernel
def _across(vector: Vector, line: Vector) -> tuple[float, float, float, float]:
    """Return the part of a vector across a unit direction, and its length."""
    along = vector[0] * line[0] + vector[1] * line[1] + vector[2] * line[2]
    x, y, z = vector[0] - along * line[0], vector[1] - along * line[1], vector[2] - along * line[2]
    return x, y, z, square_root(x * x + y * y + z * z)


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
    upper = square_root(ux * ux + uy * uy + uz * uz)
    lower = square_root(lx * lx + ly * ly + lz * lz)
    present = square_root(ex * ex + ey * ey + ez * ez)
    distance = square_root(tx * tx + ty * ty + tz * tz)
    stays = smaller(smaller(upper, lower), smaller(present, distance)) < STRAIGHT
    upper, distance = select(stays, 1.0, upper), select(stays, 1.0, distance)
    reach = softened_reach(distance, upper + lower, present)
    reach = greater(reach, greater(upper - lower, lower - upper) + 1e-6 * (upper + lower))
    dx, dy, dz = tx / distance, ty / distance, tz / distance
    sw, sx, sy, sz = quaternions.between(ex, ey, ez, tx, ty, tz)
    gx, gy, gz = quaternions.rotate(sw, sx, sy, sz, ux / upper, uy / upper, uz / upper)
    wx, wy, wz = tx - ex, ty - ey, tz - ez
    moved = square_root(wx * wx + wy * wy + wz * wz)
    px, py, pz = _bending_direction((gx, gy, gz), (dx, dy, dz), hint, moved)
    bent = _bent_length(upper, lower, reach)
    bent = smaller(greater(bent, -upper), upper)
    height = square_root(greater(upper * upper - bent * bent, 0.0))
    mx, my, mz = bent * dx + height * px, bent * dy + height * py, bent * dz + height * pz
    uw, vx, vy, vz = quaternions.between(gx, gy, gz, mx, my, mz)
    upper_turn = quaternions.product(uw, vx, vy, vz, sw, sx, sy, sz)
    gx, gy, gz = quaternions.rotate(sw, sx, sy, sz, lx, ly, lz)
    nx, ny, nz = reach * dx - mx, reach * dy - my, reach * dz - mz
    lw, vx, vy, vz = quaternions.between(gx, gy, gz, nx, ny, nz)
    lower_turn = quaternions.product(lw, vx, vy, vz, sw, sx, sy, sz)
    new_middle = (start[0] + mx, start[1] + my, start[2] + mz)
    new_end = (start[0] + reach * dx, start[1] + reach * dy, start[2] + reach * dz)
    return (
        _unless_turn(stays, upper_turn),
        _unless_turn(stays, lower_turn),
        _unless_moved(stays, middle, new_middle),
        _unless_moved(stays, end, new_end),
    )


@small_kernel
def _unless_turn(stays: bool, turn: Quaternion) -> Quaternion:
    """Return a rotation, or none where a limb stays as it is."""
    return (
        select(stays, 1.0, turn[0]),
        select(stays, 0.0, turn[1]),
        select(stays, 0.0, turn[2]),
        select(stays, 0.0, turn[3]),
    )


@small_kernel
def _unless_moved(stays: bool, old: Vector, new: Vector) -> Vector:
    """Return where a joint goes, or where it was where a limb stays as it is."""
    return (
        select(stays, old[0], new[0]),
        select(stays, old[1], new[1]),
        select(stays, old[2], new[2]),
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
