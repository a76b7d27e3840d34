"""A body at rest: names, parents and bones."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from footfall.arrays import Indices, Positions, frozen
from footfall.errors import SkeletonError, UnknownNameError

__all__ = ["Skeleton"]

LONGEST = 1e4
"""How long a bone may be along an axis [m]."""


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A tree of joints. Joint 0 is the pelvis; a parent stands before its children.

    Raises:
        SkeletonError: If there is no joint, names repeat, lengths disagree, a parent does not
            precede its child, or a number is not finite or a bone ten kilometers long.
    """

    names: tuple[str, ...]
    """One name a joint, all different."""

    parents: Indices
    """Index of each joint's parent; -1 for joint 0, and for no other. Shape (joints,)."""

    rest_offsets: Positions
    """Where each joint sits in its parent's frame [m], shape (joints, 3); zero for joint 0."""

    tip_offsets: Positions = field(default_factory=lambda: np.zeros((0, 3)))
    """Where each leaf joint's bone ends in its own frame (BVH's End Site) [m], shape
    (joints, 3); zero where nothing is known. Given empty, it is filled with zeros."""

    def __post_init__(self) -> None:
        count = len(self.names)
        if count == 0:
            raise SkeletonError("a skeleton needs at least one joint")
        parents = frozen(self.parents, np.int64)
        offsets = frozen(self.rest_offsets)
        tips = frozen(self.tip_offsets if len(self.tip_offsets) else np.zeros((count, 3)))
        if parents.shape != (count,):
            raise SkeletonError(f"{count} joint names but parents of shape {parents.shape}")
        for name, array in (("rest_offsets", offsets), ("tip_offsets", tips)):
            if array.shape != (count, 3):
                raise SkeletonError(
                    f"{name} has shape {array.shape}; {count} joints need ({count}, 3)"
                )
            if not np.isfinite(array).all():
                joint = int(np.argwhere(~np.isfinite(array))[0][0])
                raise SkeletonError(f"{name} of joint {self.names[joint]!r} is not finite")
            longest = np.abs(array).max(axis=1)
            if longest.max() > LONGEST:
                joint = int(longest.argmax())
                raise SkeletonError(
                    f"{name} of joint {self.names[joint]!r} is {longest[joint]:g} m long; a bone "
                    f"has at most {LONGEST:g} m, in meters"
                )
        self._check_tree(parents)
        object.__setattr__(self, "parents", parents)
        object.__setattr__(self, "rest_offsets", offsets)
        object.__setattr__(self, "tip_offsets", tips)

    def _check_tree(self, parents: Indices) -> None:
        seen: set[str] = set()
        for joint, name in enumerate(self.names):
            if name in seen:
                raise SkeletonError(f"two joints are named {name!r}; names must differ")
            seen.add(name)
            parent = int(parents[joint])
            if joint == 0 and parent != -1:
                raise SkeletonError(f"joint 0 has parent {parent}; the pelvis has parent -1")
            if joint > 0 and not 0 <= parent < joint:
                raise SkeletonError(
                    f"joint {joint} ({name!r}) has parent {parent}; "
                    f"a parent must stand before its child, so within 0..{joint - 1}"
                )

    @property
    def count(self) -> int:
        """How many joints there are."""
        return len(self.names)

    def index(self, name: str) -> int:
        """Return the index of the joint with this name.

        Raises:
            UnknownNameError: If no joint has it.
        """
        try:
            return self.names.index(name)
        except ValueError:
            raise UnknownNameError("joint", name, self.names) from None

    def children(self, joint: int) -> tuple[int, ...]:
        """Return the indices of a joint's children, in order."""
        return tuple(int(child) for child in np.flatnonzero(self.parents == joint))

    def bone_length(self, joint: int) -> float:
        """Return the distance from a joint's parent to it [m]."""
        return float(np.linalg.norm(self.rest_offsets[joint]))

    def same_family(self, other: Skeleton) -> bool:
        """Whether both have the same joint names and parents, in any order: their motions mix."""
        return self._parent_names() == other._parent_names()

    def order_of(self, other: Skeleton) -> Indices:
        """Return where each joint of another skeleton of this family is in this one.

        Raises:
            UnknownNameError: If a joint is not there.
        """
        return np.array([self.index(name) for name in other.names], dtype=np.int64)

    def ordered_like(self, other: Skeleton) -> Skeleton:
        """Return this skeleton with its joints in the order of another one of its family.

        Raises:
            UnknownNameError: If a joint is not there.
        """
        if self.names == other.names:
            return self
        order = self.order_of(other)
        return Skeleton(
            other.names, other.parents, self.rest_offsets[order], self.tip_offsets[order]
        )

    def _parent_names(self) -> dict[str, str | None]:
        parents: list[int] = self.parents.tolist()
        return {
            name: self.names[parent] if parent >= 0 else None
            for name, parent in zip(self.names, parents, strict=True)
        }
