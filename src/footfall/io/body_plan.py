"""What a mannequin needs to know of a skeleton at rest: directions, size and chains of joints."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np

from footfall.arrays import Floats, Indices, Positions
from footfall.io.lofts import Loft
from footfall.skeleton import Anatomy, BodyPart, Skeleton
from footfall.skeleton.landmarks import rest_positions

__all__ = ["BodyPlan", "Limb", "RingJoints", "Tone", "across_axis", "unit"]


class Tone(IntEnum):
    """What a limb is painted as: the sides differ, so that the feet are told apart."""

    BODY = 0
    FACE = 1
    LEFT = 2
    RIGHT = 3
    LEFT_FOOT = 4
    RIGHT_FOOT = 5


@dataclass(frozen=True, eq=False)
class RingJoints:
    """The two joints that move each ring of a loft that bends."""

    joints: Indices
    """The joint that moves a ring most, shape (rings,)."""

    others: Indices
    """The other one; the same where one joint alone moves the ring, shape (rings,)."""

    shares: Floats
    """The share of the other one, 0 to 0.5, shape (rings,)."""


@dataclass(frozen=True, eq=False)
class Limb:
    """A loft that moves with a joint, or bends with several."""

    joint: int
    tone: Tone
    loft: Loft
    """In the joint's frame."""
    segments: int = 14
    """Vertices around."""
    bends: RingJoints | None = None
    """None: all of it moves with the joint."""


@dataclass(frozen=True, eq=False)
class BodyPlan:
    """A skeleton at rest, with its joints unrotated: all joint frames are then parallel."""

    skeleton: Skeleton
    anatomy: Anatomy

    @cached_property
    def rest(self) -> Positions:
        """Joints at rest, the pelvis at the origin [m], shape (joints, 3)."""
        return rest_positions(self.skeleton)

    @cached_property
    def stature(self) -> float:
        """Estimated standing height [m]: hip to ankle is 0.49 of it (Winter 2009, figure 4.1)."""
        lengths = [
            float(np.linalg.norm(self.rest[one] - self.rest[other]))
            for leg in self.anatomy.legs
            for one, other in ((leg.hip, leg.knee), (leg.knee, leg.ankle))
        ]
        return sum(lengths) / 2.0 / 0.49

    @cached_property
    def up(self) -> Positions:
        """The direction of the trunk at rest."""
        hips = 0.5 * (self.rest[self.anatomy.left.hip] + self.rest[self.anatomy.right.hip])
        rise = self.rest[self.trunk_path[-1]] + self.trunk_top - hips
        if np.linalg.norm(rise) < 0.05 * self.stature:
            knees = 0.5 * (self.rest[self.anatomy.left.knee] + self.rest[self.anatomy.right.knee])
            rise = hips - knees
        return unit(rise)

    @cached_property
    def left(self) -> Positions:
        """The body's left at rest, across `up`."""
        return across_axis(
            self.rest[self.anatomy.left.hip] - self.rest[self.anatomy.right.hip], self.up
        )

    @cached_property
    def forward(self) -> Positions:
        """Where the body faces at rest."""
        return np.cross(self.left, self.up)

    @cached_property
    def trunk_path(self) -> tuple[int, ...]:
        """Joints from the pelvis up to the last one that moves the trunk."""
        if self.anatomy.chest is not None:
            return self.path(0, self.anatomy.chest)
        if self.anatomy.head is not None:
            return self.path(0, int(self.skeleton.parents[self.neck_path[0]]))
        trunk: list[int] = np.flatnonzero(self.anatomy.parts == BodyPart.TRUNK).tolist()
        return self.path(0, trunk[-1]) if trunk else (0,)

    @cached_property
    def skull(self) -> int | None:
        """The joint that carries the head; in some bodies that is the only one of the neck."""
        if self.anatomy.head is not None:
            return self.anatomy.head
        end = self.trunk_path[-1]
        lone = [
            joint
            for joint in self.skeleton.children(end)
            if self.anatomy.parts[joint] == BodyPart.TRUNK and not self.skeleton.children(joint)
        ]
        legs = self.anatomy.legs
        rise = sum((self.rest[leg.hip] - self.rest[leg.knee] for leg in legs), np.zeros(3))
        rises = [float(self.skeleton.rest_offsets[joint] @ unit(rise)) for joint in lone]
        found = max(zip(rises, lone, strict=True), default=(0.0, 0))
        return found[1] if found[0] > 0.03 * self.stature else None

    @cached_property
    def neck_path(self) -> tuple[int, ...]:
        """Joints from the lower end of the neck up to the skull; empty without a head."""
        if self.anatomy.head is None:
            return () if self.skull is None else (self.skull,)
        path = self.path(0, self.anatomy.head)
        above = [joint for joint in path if self.anatomy.parts[joint] == BodyPart.HEAD]
        return tuple(above) or path[-1:]

    @cached_property
    def trunk_top(self) -> Positions:
        """Where the neck leaves the trunk, from the last joint of the trunk at rest [m]."""
        end = self.rest[self.trunk_path[-1]]
        neck = self.rest[self.neck_path[0]] - end if self.neck_path else np.zeros(3)
        shoulders = [self.rest[arm.shoulder] for arm in self.anatomy.arms if arm is not None]
        if len(shoulders) < 2:
            return neck
        hips = 0.5 * (self.rest[self.anatomy.left.hip] + self.rest[self.anatomy.right.hip])
        middle = 0.5 * (shoulders[0] + shoulders[1])
        rise = unit(middle - hips)
        height = float((middle - end) @ rise)
        # Some necks begin between the shoulder blades: the trunk ends at the shoulders then.
        return neck if float(neck @ rise) >= 0.7 * height else 1.1 * height * rise

    def path(self, start: int, end: int) -> tuple[int, ...]:
        """Return the joints from `start` down to its descendant `end`, both included."""
        joints = [end]
        while joints[-1] not in (start, -1):
            joints.append(int(self.skeleton.parents[joints[-1]]))
        return tuple(joint for joint in reversed(joints) if joint >= 0)

    def visible(self, offset: Positions) -> bool:
        """Whether a bone is long enough to be worth a limb."""
        return float(np.linalg.norm(offset)) > 0.008 * self.stature


def unit(vector: Positions) -> Positions:
    """Return the direction of a vector that is not zero."""
    return vector / np.linalg.norm(vector)


def across_axis(vector: Positions, axis: Positions) -> Positions:
    """Return the direction of the part of `vector` across the unit `axis`; any, if that is zero."""
    part = vector - (vector @ axis) * axis
    if np.linalg.norm(part) < 1e-6 * max(1.0, float(np.linalg.norm(vector))):
        spare: Positions = np.eye(3)[int(np.abs(axis).argmin())]
        part = np.cross(axis, spare)
    return unit(part)
