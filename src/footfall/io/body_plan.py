"""What a mannequin needs to know of a skeleton at rest: directions, size and chains of joints."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np

from footfall.arrays import Floats, Indices, Positions
from footfall.io.lofts import Loft
from footfall.skeleton import Anatomy, BodyPart, Skeleton

__all__ = ["BodyPlan", "Limb", "Tone", "across_axis", "unit"]


class Tone(IntEnum):
    """What a limb is painted as: the sides differ, so that the feet are told apart."""

    BODY = 0
    FACE = 1
    LEFT = 2
    RIGHT = 3
    LEFT_FOOT = 4
    RIGHT_FOOT = 5


@dataclass(frozen=True, eq=False)
class Limb:
    """A loft that moves with a joint."""

    joint: int
    tone: Tone
    loft: Loft
    """In the joint's frame."""
    segments: int = 14
    """Vertices around."""


@dataclass(frozen=True, eq=False)
class BodyPlan:
    """A skeleton at rest, with its joints unrotated: all joint frames are then parallel."""

    skeleton: Skeleton
    anatomy: Anatomy

    @cached_property
    def rest(self) -> Positions:
        """Joints at rest, the pelvis at the origin [m], shape (joints, 3)."""
        positions = np.zeros((self.skeleton.count, 3))
        for joint, parent in enumerate(self.skeleton.parents.tolist()):
            if parent >= 0:
                positions[joint] = positions[parent] + self.skeleton.rest_offsets[joint]
        return positions

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
        rise = self.rest[self.trunk_path[-1]] - hips
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
        """Joints from the pelvis up to the neck's lower end."""
        parts = self.anatomy.parts
        tops = np.flatnonzero(parts == BodyPart.HEAD)
        if len(tops) == 0:
            tops = np.flatnonzero(parts == BodyPart.TRUNK)[-1:]
        return self.path(0, int(tops[0])) if len(tops) else (0,)

    def path(self, start: int, end: int) -> tuple[int, ...]:
        """Return the joints from `start` down to its descendant `end`, both included."""
        joints = [end]
        while joints[-1] not in (start, -1):
            joints.append(int(self.skeleton.parents[joints[-1]]))
        return tuple(joint for joint in reversed(joints) if joint >= 0)

    def chain(self, start: int) -> tuple[int, ...]:
        """Return the joints from `start` down towards the leaf that is farthest along."""
        reach = self._reach
        joints = [start]
        while children := self.skeleton.children(joints[-1]):
            joints.append(max(children, key=lambda child: reach[child]))
        return tuple(joints)

    @cached_property
    def _reach(self) -> Floats:
        """Length of the longest way from each joint's parent to a tip below it [m]."""
        reach = np.linalg.norm(self.skeleton.tip_offsets, axis=-1)
        lengths = np.linalg.norm(self.skeleton.rest_offsets, axis=-1)
        for joint in range(self.skeleton.count - 1, -1, -1):
            below = [reach[child] for child in self.skeleton.children(joint)]
            reach[joint] = lengths[joint] + max([reach[joint], *below])
        return reach

    def first_of(self, part: BodyPart) -> int | None:
        """Return the uppermost joint of a part of the body, or None where it has none."""
        joints: Indices = np.flatnonzero(self.anatomy.parts == part)
        return int(joints[0]) if len(joints) else None

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
