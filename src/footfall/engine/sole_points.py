"""Heel and toe of each foot in the world, before footprints (part of stage 7)."""

from __future__ import annotations

from footfall.blending.root import mix_point
from footfall.compilation import small_kernel
from footfall.engine.feet import stand_level
from footfall.engine.foot_turns import foot_rotation
from footfall.engine.moment import Moment
from footfall.engine.record import Character
from footfall.geometry import quaternions, transforms
from footfall.skeleton.rig import Rig

__all__ = ["move_points"]


@small_kernel
def move_points(
    rig: Rig, me: Character, moment: Moment, side: int, dt: float
) -> tuple[float, float]:
    """Find heel and toe in the world; return how far that moved the carrying point [m]."""
    share = me.toe_shares[side]
    old_x = mix_point(me.world_points, side, share, 0)
    old_z = mix_point(me.world_points, side, share, 2)
    toe_x, toe_z = me.world_points[side, 1, 0], me.world_points[side, 1, 2]
    _tilt_points(rig, me, moment, side)
    if dt > 0.0 and not me.placed:
        me.toe_velocity[side, 0] = (me.world_points[side, 1, 0] - toe_x) / dt
        me.toe_velocity[side, 1] = (me.world_points[side, 1, 2] - toe_z) / dt
    return (
        mix_point(me.world_points, side, share, 0) - old_x,
        mix_point(me.world_points, side, share, 2) - old_z,
    )


@small_kernel
def _tilt_points(rig: Rig, me: Character, moment: Moment, side: int) -> None:
    """Write heel and toe in the world, the sole turned and tilted about its middle."""
    root, leg, points = me.root, rig.leg_length, moment.points[side]
    if me.foot_slope[side, 0] == 0.0 and me.foot_slope[side, 1] == 0.0 and not me.twisted:
        stand_level(rig, me, moment, side)
        return
    me.tilt[side, 0], me.tilt[side, 1] = me.foot_slope[side, 0], me.foot_slope[side, 1]
    w, qx, qy, qz = foot_rotation(me, side, me.tilt[side, 0], me.tilt[side, 1])
    for point in range(2):
        # Half of the sole, from its middle to this point.
        other = points[1 - point]
        x, z = transforms.apply(
            0.0,
            0.0,
            root[2],
            0.5 * leg * (points[point, 0] - other[0]),
            0.5 * leg * (points[point, 2] - other[2]),
        )
        y = 0.5 * leg * (points[point, 1] - other[1])
        mx, mz = transforms.apply(
            root[0],
            root[1],
            root[2],
            0.5 * leg * (points[point, 0] + other[0]),
            0.5 * leg * (points[point, 2] + other[2]),
        )
        tx, ty, tz = quaternions.rotate(w, qx, qy, qz, x, y, z)
        me.world_points[side, point, 0] = mx + tx
        me.world_points[side, point, 1] = 0.5 * leg * (points[point, 1] + other[1]) + ty
        me.world_points[side, point, 2] = mz + tz
        me.tilt_rise[side, point] = ty - y
