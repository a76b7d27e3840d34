"""The feet of the blended pose: where they stand if nothing plays, where heel and toe are."""

from __future__ import annotations

from footfall.arrays import SmallFloats
from footfall.compilation import small_kernel
from footfall.engine.moment import Moment
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.geometry import quaternions, transforms
from footfall.octets import LANES
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import ANKLES
from footfall.skeleton.rig import Rig
from footfall.support import Support

__all__ = ["carries", "locate_feet", "stance_shift", "stand_level", "stand_where_planted"]

LEGS = int(BodyPart.LEGS)
LEFT_FOOT = int(Support.LEFT) & ~int(Support.RIGHT)
RIGHT_FOOT = int(Support.RIGHT) & ~int(Support.LEFT)
DOUBLE = int(Support.DOUBLE)


@small_kernel
def carries(support: int, side: int) -> bool:
    """Return whether a foot, 0 left or 1 right, is among those that carry."""
    return (support & (LEFT_FOOT if side == 0 else RIGHT_FOOT)) != 0


@small_kernel
def stand_where_planted(shelf: Shelf, me: Character, moment: Moment) -> None:
    """Let the neutral motion, where it takes over from both feet, stand where they are.

    Otherwise planted feet would have to slide together, or be held far from their own pose.
    """
    weight = me.weights[SEATS, LEGS]
    if weight <= 0.0:
        me.stands = False
        return
    first = ANKLES + shelf.keys.shape[1] - LANES
    last = shelf.keys.shape[0] - 1
    if not me.stands:
        me.stands = True
        apart = me.support == DOUBLE and not me.fresh and me.synchronized
        for side in range(2):
            for axis in range(2):
                own = shelf.keys[last, first + 3 * side + 2 * axis]
                shown = me.shown_ankles[side, axis]
                me.stance[side, axis] = shown - own if apart else 0.0
    for side in range(2):
        x, z = stance_shift(me, side)
        moment.effectors[ANKLES + 3 * side] += x
        moment.effectors[ANKLES + 3 * side + 2] += z


@small_kernel
def stance_shift(me: Character, side: int) -> tuple[float, float]:
    """Return how far a foot stands from where the blended pose has it, in leg lengths: x and z."""
    weight = me.weights[SEATS, LEGS] if me.stands else 0.0
    return weight * me.stance[side, 0], weight * me.stance[side, 1]


@small_kernel
def locate_feet(shelf: Shelf, moment: Moment, blended: SmallFloats) -> None:
    """Find heel and toe of the blended feet (stage 5).

    Written: `Moment.points` in leg lengths, `Moment.heights` over each point's own height at rest.

    Args:
        shelf: The library.
        moment: What this frame has found out of the character.
        blended: Its blended pose by component, shape (4 rows + 8,).
    """
    rows = (blended.shape[0] - LANES) // 4
    for side in range(2):
        foot = shelf.joints + side
        w, qx = float(blended[foot]), float(blended[foot + rows])
        qy, qz = float(blended[foot + 2 * rows]), float(blended[foot + 3 * rows])
        for point in range(2):
            offset, resting = shelf.points[side, point], float(moment.resting[2 * side + point])
            x, y, z = quaternions.rotate(w, qx, qy, qz, offset[0], offset[1], offset[2])
            moment.points[side, point, 0] = x + moment.effectors[1 + 3 * side]
            moment.points[side, point, 1] = y + moment.effectors[2 + 3 * side]
            moment.points[side, point, 2] = z + moment.effectors[3 + 3 * side]
            moment.heights[side, point] = moment.points[side, point, 1] - resting


@small_kernel
def stand_level(rig: Rig, me: Character, moment: Moment, side: int) -> None:
    """Write heel and toe of a foot in the world, its sole not tilted."""
    me.tilt[side, 0] = me.tilt[side, 1] = 0.0
    for point in range(2):
        own = moment.points[side, point]
        leg = rig.leg_length
        x, z = transforms.turn(me.facing[0], me.facing[1], leg * own[0], leg * own[2])
        me.world_points[side, point, 0] = me.root[0] + x
        me.world_points[side, point, 1] = leg * own[1]
        me.world_points[side, point, 2] = me.root[1] + z
        me.tilt_rise[side, point] = 0.0
