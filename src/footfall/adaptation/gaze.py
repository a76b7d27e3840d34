"""A head that looks at a place after the blend."""

from __future__ import annotations

import math

from footfall.adaptation.goal_body import GoalBody
from footfall.arrays import Positions, Rotations
from footfall.compilation import kernel
from footfall.geometry import quaternions

__all__ = ["look_at"]

WIDEST_LOOK = math.radians(75.0)
"""How far the head turns from the chest at most."""

NECK_SHARE = 0.4
"""How much of that the neck does."""


@kernel
def look_at(
    body: GoalBody,
    target: tuple[float, float, float],
    share: float,
    rotations: Rotations,
    positions: Positions,
) -> float:
    """Turn neck and head so that the face looks at a target, as far as a neck turns.

    Args:
        body: What meets goals.
        target: In the world [m].
        share: How much of the way they turn, 0 to 1.
        rotations: Joints in the world, shape (joints, 4); those of neck and head are rewritten.
        positions: Likewise [m], shape (joints, 3).

    Returns:
        By how much the target is out of reach [rad].
    """
    head, chest = body.head, rotations[body.chest]
    place = positions[head]
    tx, ty, tz = target[0] - place[0], target[1] - place[1], target[2] - place[2]
    if tx * tx + ty * ty + tz * tz < 1e-12:
        return 0.0
    ahead = body.forward[0]
    cx, cy, cz = quaternions.rotate(
        chest[0], chest[1], chest[2], chest[3], ahead[0], ahead[1], ahead[2]
    )
    w, x, y, z = quaternions.between(cx, cy, cz, tx, ty, tz)
    angle = 2.0 * math.acos(min(max(w, -1.0), 1.0))
    if angle > WIDEST_LOOK:
        tx, ty, tz = _turned_at_most((cx, cy, cz), (x, y, z))
    face = rotations[head]
    ahead = body.forward[1]
    fx, fy, fz = quaternions.rotate(
        face[0], face[1], face[2], face[3], ahead[0], ahead[1], ahead[2]
    )
    turn = quaternions.between(fx, fy, fz, tx, ty, tz)
    if body.neck >= 0:
        _turn_part(body, 1, body.neck, turn, NECK_SHARE * share, rotations, positions)
        face = rotations[head]
        fx, fy, fz = quaternions.rotate(
            face[0], face[1], face[2], face[3], ahead[0], ahead[1], ahead[2]
        )
        turn = quaternions.between(fx, fy, fz, tx, ty, tz)
        share = share * (1.0 - NECK_SHARE) / max(1.0 - NECK_SHARE * share, 1e-9)
    _turn_part(body, 2, head, turn, share, rotations, positions)
    return max(0.0, angle - WIDEST_LOOK)


@kernel
def _turned_at_most(
    ahead: tuple[float, float, float], axis: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Return a direction turned about an axis as far as a neck turns."""
    length = max(math.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2), 1e-12)
    sine = math.sin(0.5 * WIDEST_LOOK) / length
    return quaternions.rotate(
        math.cos(0.5 * WIDEST_LOOK),
        sine * axis[0],
        sine * axis[1],
        sine * axis[2],
        ahead[0],
        ahead[1],
        ahead[2],
    )


@kernel
def _turn_part(
    body: GoalBody,
    mark: int,
    pivot: int,
    turn: tuple[float, float, float, float],
    share: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Turn neck or head, and all that it carries, part of the way."""
    w, x, y, z = quaternions.nlerp(
        1.0, 0.0, 0.0, 0.0, turn[0], turn[1], turn[2], turn[3], min(max(share, 0.0), 1.0)
    )
    px, py, pz = positions[pivot, 0], positions[pivot, 1], positions[pivot, 2]
    for joint in range(pivot, positions.shape[0]):
        if body.carried[joint] < mark:
            continue
        place, q = positions[joint], rotations[joint]
        dx, dy, dz = quaternions.rotate(w, x, y, z, place[0] - px, place[1] - py, place[2] - pz)
        place[0], place[1], place[2] = px + dx, py + dy, pz + dz
        q[0], q[1], q[2], q[3] = quaternions.product(w, x, y, z, q[0], q[1], q[2], q[3])
