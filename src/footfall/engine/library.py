"""The motion library: every clip and its supports, packed once for the kernels."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from footfall.arrays import Floats, SmallFloats
from footfall.engine.packing import PackedClip, pack_clip, pack_standing
from footfall.engine.priorities import parse_priority
from footfall.engine.shelf import Shelf, entry_type
from footfall.errors import ArgumentError, ClipError, SkeletonError, UnknownNameError
from footfall.motion import Clip, with_soles
from footfall.motion.retargeting import map_clip, retarget
from footfall.skeleton import Anatomy, Skeleton, find_anatomy
from footfall.skeleton.normalized import by_component
from footfall.skeleton.rig import Rig, rig_of
from footfall.support import SupportSequence
from footfall.sync.tables import Planner, SequenceTable, check_registration

__all__ = ["LONGEST_DISAGREEMENT", "Action", "MotionLibrary"]

LONGEST_DISAGREEMENT = 0.02
"""How far a support sequence may be from lasting as long as its clip [s]."""


@dataclass(frozen=True, eq=False)
class Action:
    """A motion that can be started and stopped."""

    name: str
    """What commands call it."""

    clip: Clip
    """The motion."""

    supports: SupportSequence
    """What carries the body when."""

    priority: Floats
    """Priority on each body part, >= 0, shape (parts,)."""

    fade_in: float
    """How long a start takes to become complete [s]."""

    fade_out: float
    """How long a stop takes to become complete [s]."""

    packed: PackedClip
    """The clip, normalized."""


class MotionLibrary:
    """Actions of one skeleton family, packed for the kernels.

    A new clip is appended: it touches no other, and no index ever changes.
    """

    def __init__(self, *, skeleton: Skeleton | None = None, neutral: Clip | None = None) -> None:
        """Begin an empty library.

        Args:
            skeleton: The order in which its joints come; by default that of the first clip.
            neutral: Its first frame is how a character stands that does nothing. By default
                the mean posture of the first clip that is added, on both feet.
        """
        self._neutral = neutral
        self._actions: list[Action] = []
        self._skeleton = skeleton
        self._anatomy: Anatomy | None = None
        self._standing: SmallFloats | None = None
        self._resting: Floats | None = None

    @property
    def actions(self) -> tuple[Action, ...]:
        """All actions; an action's id is its index."""
        return tuple(self._actions)

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

    def rig(self, skeleton: Skeleton | None = None) -> Rig:
        """Return a body of this library's family, packed for the kernels."""
        return rig_of(skeleton or self.skeleton, self.anatomy)

    def index(self, name: str) -> int:
        """Return the id of an action.

        Raises:
            UnknownNameError: If there is none of this name.
        """
        for index, action in enumerate(self._actions):
            if action.name == name:
                return index
        raise UnknownNameError("action", name, [action.name for action in self._actions])

    def add(
        self,
        name: str,
        clip: Clip,
        supports: SupportSequence,
        *,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> int:
        """Add a motion, and return its id.

        Args:
            name: What commands will call it; new to this library.
            clip: The motion.
            supports: What carries the body when; as long as the clip.
            priority: Of the whole body or by body part, as in `parse_priority`.
            fade_in: How long a start takes to become complete [s], >= 0.
            fade_out: How long a stop takes to become complete [s], >= 0.

        Raises:
            ArgumentError: If the name is taken, or a number is out of range.
            SkeletonError: If the clip's skeleton has other joints than the library's, and its
                motion cannot be retargeted.
            ClipError: If the supports do not fit the clip.
            SupportSequenceError: If the supports can never be synchronized with others.
        """
        if any(action.name == name for action in self._actions):
            raise ArgumentError(f"there already is an action named {name!r}; names must differ")
        for label, seconds in (("fade_in", fade_in), ("fade_out", fade_out)):
            if not (math.isfinite(seconds) and seconds >= 0.0):
                raise ArgumentError(f"{label} of {name!r} is {seconds} s; it must be >= 0")
        clip = self._in_family(name, clip)
        _check_supports(name, clip, supports)
        values = parse_priority(priority)
        if not self._actions:
            self._anatomy = with_soles(self.anatomy, *clip.world_poses())
        packed = pack_clip(clip, self.anatomy, supports)
        if self._standing is None:
            self._stand_like(packed)
        self._actions.append(Action(name, clip, supports, values, fade_in, fade_out, packed))
        return len(self._actions) - 1

    def _in_family(self, name: str, clip: Clip) -> Clip:
        """Return a clip on a skeleton of this library's family, its joints in their order."""
        if self._skeleton is None:
            self._skeleton = clip.skeleton
        if self._skeleton.same_family(clip.skeleton):
            return clip.ordered_like(self._skeleton)
        shown = self._actions[0].clip if self._actions else self._neutral
        try:
            body_map = map_clip(clip, self._skeleton, shown)
            return retarget(clip, self._skeleton, body_map)
        except SkeletonError as error:
            raise SkeletonError(
                f"{name!r} moves another skeleton and cannot be retargeted: {error}"
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

    def shelf(self, planner: Planner = "footfall") -> Shelf:
        """Return the library as the kernels take it.

        Raises:
            ArgumentError: If no clip has been added yet.
        """
        actions = self._actions
        if not actions or self._standing is None or self._resting is None:
            raise ArgumentError("the library is empty; add a clip first")
        rig = self.rig()
        sequences = [action.supports for action in actions]
        standing_root = np.zeros((1, 3))
        return Shelf(
            keys=by_component(
                np.concatenate([*(action.packed.keys for action in actions), self._standing]),
                self.skeleton.count,
            ),
            roots=np.concatenate([*(action.packed.roots for action in actions), standing_root]),
            entries=_entries(actions),
            resting_heights=np.stack(
                [*(action.packed.resting_heights for action in actions), self._resting]
            ),
            table=SequenceTable.of(sequences),
            phase_starts=np.concatenate([one.boundaries[:-1] for one in sequences]),
            points=rig.foot_points / rig.leg_length,
            use_paper_cubic=planner == "paper",
            joints=self.skeleton.count,
        )


def _check_supports(name: str, clip: Clip, supports: SupportSequence) -> None:
    check_registration(supports)
    if supports.cyclic != clip.cyclic:
        kinds = {True: "cyclic", False: "once"}
        raise ClipError(
            f"the clip of {name!r} is {kinds[clip.cyclic]}, its supports are "
            f"{kinds[supports.cyclic]}; both must be the same"
        )
    if abs(supports.duration - clip.duration) > LONGEST_DISAGREEMENT:
        raise ClipError(
            f"the clip of {name!r} lasts {clip.duration:.3f} s, its supports "
            f"{supports.duration:.3f} s; both must last the same"
        )


def _entries(actions: list[Action]) -> Any:
    """Return one record an action, in their order."""
    entries = np.zeros(len(actions), dtype=entry_type)
    frame = phase = 0
    for entry, action in zip(entries, actions, strict=True):
        clip, count = action.clip, len(action.supports.phases)
        entry["first_frame"], entry["frame_count"] = frame, clip.frames
        entry["fps"], entry["duration"], entry["cyclic"] = clip.fps, clip.duration, clip.cyclic
        entry["phase_first"], entry["phase_count"] = phase, count
        entry["priorities"] = action.priority
        entry["fade_in"], entry["fade_out"] = action.fade_in, action.fade_out
        frame, phase = frame + clip.frames, phase + count
    return entries
