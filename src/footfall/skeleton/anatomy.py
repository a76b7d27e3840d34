"""Which joint is a hip, a knee, an ankle, a toe; which joints move with the arms."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum

from footfall.arrays import Indices
from footfall.skeleton.skeleton import Skeleton

__all__ = ["Anatomy", "Arm", "BodyPart", "FootPoint", "Leg", "arm_length", "leg_length", "resized"]


class BodyPart(IntEnum):
    """A part of the body with a priority of its own."""

    LEGS = 0
    """The legs, the pelvis, and with them the way through the world."""

    TRUNK = 1
    """The spine."""

    HEAD = 2
    """Neck and head."""

    LEFT_ARM = 3
    """Left clavicle to left fingers."""

    RIGHT_ARM = 4
    """Right clavicle to right fingers."""


@dataclass(frozen=True, slots=True)
class FootPoint:
    """A point of a foot that can carry the body."""

    joint: int
    """The joint it moves with: an ankle or a toe joint."""

    offset: tuple[float, float, float]
    """Where it sits in that joint's frame [m]."""


@dataclass(frozen=True, slots=True)
class Leg:
    """One leg, by joint indices."""

    hip: int
    """The upper end of the thigh."""

    knee: int
    """The upper end of the shank."""

    ankle: int
    """The lower end of the shank; its rotation is the foot's."""

    heel: FootPoint
    """The hind point of the foot: the ankle joint itself, where nothing better is known."""

    toe: FootPoint
    """The fore point of the foot: the toe joint, or else the tip of the foot's bone."""


@dataclass(frozen=True, slots=True)
class Arm:
    """One arm, by joint indices."""

    shoulder: int
    """The upper end of the upper arm."""

    elbow: int
    """The upper end of the forearm."""

    wrist: int
    """The lower end of the forearm; its rotation is the hand's."""


@dataclass(frozen=True, eq=False)
class Anatomy:
    """What the joints of a skeleton are, and why that was concluded."""

    left: Leg
    """The left leg."""

    right: Leg
    """The right leg."""

    parts: Indices
    """The `BodyPart` of each joint, shape (joints,)."""

    reasons: tuple[str, ...]
    """One sentence for each conclusion, for `footfall info`."""

    arms: tuple[Arm | None, Arm | None] = (None, None)
    """The left and the right arm; None where none was found."""

    head: int | None = None
    """The joint at the lower end of the skull; None where none was found."""

    chest: int | None = None
    """The joint that carries both arms; None unless both were found."""

    @property
    def legs(self) -> tuple[Leg, Leg]:
        """The left and the right leg, in the order of all arrays over feet."""
        return (self.left, self.right)


def resized(anatomy: Anatomy, factor: float) -> Anatomy:
    """Return the anatomy of a body that is larger by a factor: its soles are farther down."""
    if abs(factor - 1.0) < 1e-9:
        return anatomy

    def farther(point: FootPoint) -> FootPoint:
        x, y, z = point.offset
        return FootPoint(point.joint, (factor * x, factor * y, factor * z))

    left, right = (
        replace(leg, heel=farther(leg.heel), toe=farther(leg.toe)) for leg in anatomy.legs
    )
    return replace(anatomy, left=left, right=right)


def leg_length(skeleton: Skeleton, leg: Leg) -> float:
    """Return the length of thigh and shank together [m]."""
    return _chain_length(skeleton, leg.hip, leg.ankle)


def arm_length(skeleton: Skeleton, arm: Arm) -> float:
    """Return the length of upper arm and forearm together [m]."""
    return _chain_length(skeleton, arm.shoulder, arm.wrist)


def _chain_length(skeleton: Skeleton, upper: int, lower: int) -> float:
    """Return the sum of the bones from a joint down to one below it [m]."""
    length = 0.0
    joint = lower
    while joint != upper:
        length += skeleton.bone_length(joint)
        joint = int(skeleton.parents[joint])
    return length
