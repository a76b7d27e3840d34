"""A performance: what a motion prescribes over time, and the clip that it becomes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, Seconds
from footfall.geometry import continuous, from_axis_angle, from_euler, rotate
from footfall.motion import Clip
from footfall.samples.body import HIP_DROP, HIP_HALF_WIDTH, sample_skeleton
from footfall.samples.footsteps import FootPath
from footfall.samples.limbs import arm_rotations, leg_rotations, relative, share

__all__ = ["Performance", "hip_offsets", "trunk_rotations"]

_FEET = (("Left", 1.0), ("Right", -1.0))


@dataclass(frozen=True, eq=False)
class Performance:
    """One body over time.

    Angles of pelvis, chest and head are turns in the world: heading (to the left), lean
    (forward), tilt (left side up) [rad], applied in this order from outside.
    """

    pelvis_positions: Positions
    """The pelvis joint [m], shape (times, 3)."""

    pelvis_angles: Floats
    """Shape (times, 3)."""

    chest_angles: Floats
    """Shape (times, 3)."""

    head_angles: Floats
    """Shape (times, 3)."""

    arm_angles: Floats
    """Left and right arm as in `arm_rotations`, shape (times, 2, 5)."""

    feet: tuple[FootPath, FootPath]
    """Left and right foot."""

    def clip(self, times: Seconds, fps: float, *, name: str, cyclic: bool) -> Clip:
        """Return the clip of this performance, with one sentence of provenance."""
        skeleton = sample_skeleton()
        rotations = np.zeros((len(times), skeleton.count, 4))
        rotations[..., 0] = 1.0

        def turn(joint: str, values: Rotations) -> None:
            rotations[:, skeleton.index(joint)] = values

        pelvis = trunk_rotations(self.pelvis_angles)
        turn("Hips", pelvis)
        self._turn_trunk(pelvis, turn)
        for index, (side, sign) in enumerate(_FEET):
            upper, lower = arm_rotations(self.arm_angles[:, index], sign)
            turn(f"{side}Arm", upper)
            turn(f"{side}ForeArm", lower)
            foot = self.feet[index]
            hips = self.pelvis_positions + rotate(pelvis, hip_offsets()[index])
            headings = 0.5 * (self.pelvis_angles[:, 0] + foot.angles[:, 0])
            thigh, shank = leg_rotations(hips, foot.ankles, headings)
            turn(f"{side}UpLeg", relative(pelvis, thigh))
            turn(f"{side}Leg", relative(thigh, shank))
            turn(f"{side}Foot", relative(shank, foot.rotations))
            turn(f"{side}ToeBase", from_axis_angle(np.array([-1.0, 0.0, 0.0]), foot.angles[:, 2]))
        made = f"made by footfall as sample {name!r}"
        return Clip(
            skeleton, self.pelvis_positions, continuous(rotations), fps, cyclic, name, (made,)
        )

    def _turn_trunk(self, pelvis: Rotations, turn: Callable[[str, Rotations], None]) -> None:
        chest = trunk_rotations(self.chest_angles)
        third = share(relative(pelvis, chest), 1.0 / 3.0)
        for joint in ("Spine", "Spine1", "Spine2"):
            turn(joint, third)
        half = share(relative(chest, trunk_rotations(self.head_angles)), 0.5)
        for joint in ("Neck", "Head"):
            turn(joint, half)


def trunk_rotations(angles: Floats) -> Rotations:
    """Return rotations, shape (..., 4), from heading, lean and tilt [rad], shape (..., 3)."""
    return from_euler("YXZ", angles)


def hip_offsets() -> Positions:
    """Return the left and the right hip in the pelvis's frame [m], shape (2, 3)."""
    return np.array([[HIP_HALF_WIDTH, -HIP_DROP, 0.0], [-HIP_HALF_WIDTH, -HIP_DROP, 0.0]])
