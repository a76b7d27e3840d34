"""The body of a motion library: every clip is brought onto it, whoever performed it."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

from footfall.arrays import Floats, SmallFloats
from footfall.engine.action import Action, check_supports
from footfall.engine.layer import Layer
from footfall.engine.packing import (
    PackedClip,
    carrying_feet,
    pack_clip,
    pack_standing,
    rest_alike,
)
from footfall.errors import ArgumentError, SkeletonError, UnknownNameError
from footfall.motion import Clip, with_soles
from footfall.motion.retargeting import map_clip, retarget
from footfall.skeleton import Anatomy, Skeleton, find_anatomy, leg_length, resized
from footfall.skeleton.rig import Rig, rig_of
from footfall.support import SupportSequence

__all__ = ["LibraryBody"]


class LibraryBody:
    """The part of a motion library that knows its body, and fits clips to it."""

    def __init__(self, *, skeleton: Skeleton | None = None, neutral: Clip | None = None) -> None:
        """Begin an empty library.

        Args:
            skeleton: The order in which its joints come; by default that of the first clip.
            neutral: Its first frame is how a character stands that does nothing. By default
                the mean posture of the first clip that is added, on both feet.
        """
        self._neutral = neutral
        self._actions: list[Action] = []
        self._resampled: int = 0
        self._given: dict[str, Clip] = {}
        self._layers: list[Layer] = []
        self._additions: list[Callable[[Any], int]] = []
        self._adapted: list[Any] = []
        self._skeleton = skeleton
        self._anatomy: Anatomy | None = None
        self._standing: SmallFloats | None = None
        self._resting: Floats | None = None

    @property
    def skeleton(self) -> Skeleton:
        """The body whose joints, in their order, all its motions move.

        Raises:
            ArgumentError: If no clip has been added yet.
        """
        if self._skeleton is None:
            raise ArgumentError("the library is empty; add a clip first")
        return self._skeleton

    @property
    def anatomy(self) -> Anatomy:
        """What the joints of `skeleton` are, its heels on the soles.

        The first clip tells where those are: a foot is one, in whatever motion.
        """
        if self._anatomy is None:
            self._anatomy = find_anatomy(self.skeleton)
        return self._anatomy

    @property
    def actions(self) -> tuple[Action, ...]:
        """All actions; an action's id is its index."""
        return tuple(self._actions)

    def index(self, name: str) -> int:
        """Return the id of an action.

        Raises:
            UnknownNameError: If there is none of this name.
        """
        for index, action in enumerate(self._actions):
            if action.name == name:
                return index
        raise UnknownNameError("action", name, [action.name for action in self._actions])

    def rig(self, skeleton: Skeleton | None = None) -> Rig:
        """Return a body of this library's family, packed for the kernels."""
        if skeleton is None:
            return rig_of(self.skeleton, self.anatomy)
        return rig_of(skeleton, resized(self.anatomy, 1.0 / self._size_beside(skeleton)))

    @contextmanager
    def _unchanged_if_refused(self) -> Generator[None, None, None]:
        """Let a first clip that is refused leave the library without a body, as it was."""
        before = (self._skeleton, self._anatomy, self._standing, self._resting)
        try:
            yield
        except BaseException:
            self._skeleton, self._anatomy, self._standing, self._resting = before
            raise

    def _packed(self, label: str, clip: Clip, supports: SupportSequence) -> tuple[Clip, PackedClip]:
        """Return a clip of this library's family, and the same normalized.

        Args:
            label: What messages call it.
            clip: Of any family.
            supports: What it stands on.
        """
        clip = self._in_family(label, clip, supports)
        check_supports(label, clip, supports)
        size = self._size_beside(clip.skeleton)
        if self._standing is None:
            seen = with_soles(self.anatomy, *clip.world_poses())
            self._anatomy = resized(seen, size)
        packed = pack_clip(clip, resized(self.anatomy, 1.0 / size), supports)
        if self._standing is None:
            self._stand_like(packed)
        assert self._resting is not None
        return clip, rest_alike(packed, self._resting)

    def _size_beside(self, skeleton: Skeleton) -> float:
        """Return how long the legs of this library's body are, beside those of another one."""
        own, other = (
            sum(leg_length(one, leg) for leg in self.anatomy.legs)
            for one in (self.skeleton, skeleton)
        )
        return own / other

    def _stand_as(self, other: LibraryBody) -> None:
        """Let a character of this library that does nothing stand as one of another library.

        Raises:
            SkeletonError: If that posture cannot be retargeted.
        """
        if other._neutral is not None:
            both = SupportSequence.parse("D")
            self._neutral = self._in_family("the neutral motion", other._neutral, both)

    def _in_family(self, label: str, clip: Clip, supports: SupportSequence) -> Clip:
        """Return a clip on a skeleton of this library's family, its joints in their order."""
        if self._skeleton is None:
            self._skeleton = clip.skeleton
        if self._skeleton.same_family(clip.skeleton):
            return clip.ordered_like(self._skeleton)
        shown = self._actions[0].clip if self._actions else self._neutral
        try:
            body_map = map_clip(clip, self._skeleton, shown)
            return retarget(clip, self._skeleton, body_map, carrying_feet(clip, supports))
        except SkeletonError as error:
            raise SkeletonError(
                f"{label} moves another skeleton and cannot be retargeted: {error}"
            ) from error

    def _stand_like(self, packed: PackedClip) -> None:
        joints = self.skeleton.count
        if self._neutral is None:
            self._standing = pack_standing(packed, joints)
            self._resting = packed.resting_heights
            return
        both = SupportSequence.parse("D")
        stance = pack_clip(self._neutral.ordered_like(self.skeleton), self.anatomy, both)
        self._standing = stance.keys[:1]
        self._resting = stance.resting_heights
