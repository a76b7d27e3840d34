"""The motion library: every clip and its supports, packed once for the kernels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from footfall.actions import GaitCycle, Locomotion
from footfall.engine.action import Action, entries_of
from footfall.engine.layer import layer_shelf_of
from footfall.engine.library_sources import LibrarySources
from footfall.engine.packing import PackedClip
from footfall.engine.priorities import parse_priority
from footfall.engine.shelf import Shelf
from footfall.engine.sole_keys import resting_octets, sole_keys_of
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.skeleton.normalized import by_component
from footfall.support import SupportSequence
from footfall.sync.tables import Planner, SequenceTable

__all__ = ["Action", "MotionLibrary"]


class MotionLibrary(LibrarySources):
    """Actions of one skeleton family, packed for the kernels.

    A new clip is appended: it touches no other, and no index ever changes.
    """

    def adapted(self, skeleton: Skeleton) -> MotionLibrary:
        """Return this library as another body performs it: all its actions and layers by their ids.

        It is made once for a body; asked for again it learns what has been added since.

        Args:
            skeleton: That very body is asked for again, of whatever family.

        Raises:
            SkeletonError: If a motion cannot be retargeted.
        """
        other = next((one for one in self._adapted if one.skeleton is skeleton), None)
        if other is None:
            other = type(self)(skeleton=skeleton)
            other._stand_as(self)
            self._adapted.append(other)
        for addition in self._additions[other.size :]:
            addition(other)
        return other

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
        self._check_new(name, fade_in, fade_out)
        values = parse_priority(priority)
        given = clip
        with self._unchanged_if_refused():
            clip, packed = self._packed(repr(name), clip, supports)
        self._given[name] = given
        self._additions.append(
            lambda other: other.add(
                name,
                self._given[name],
                supports,
                priority=priority,
                fade_in=fade_in,
                fade_out=fade_out,
            )
        )
        self._actions.append(Action(name, clip, supports, values, fade_in, fade_out, packed))
        return len(self._actions) - 1

    def add_locomotion(
        self,
        name: str,
        clips: Sequence[tuple[Clip, SupportSequence]],
        *,
        speed: float | None = None,
        turn: float | None = None,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> int:
        """Add a gait that follows a speed and a turn, and return its id.

        Args:
            name: What commands will call it; new to this library.
            clips: Cyclic motions and what they stand on, which step on the same feet in the same
                order, at different speeds or turns: walks and runs, straight on and in curves.
            speed: Forward, with which it begins [m/s]; by default the first clip's.
            turn: To the left, likewise [rad/s].
            priority: Of the whole body or by body part, as in `parse_priority`.
            fade_in: How long a start takes to become complete [s], >= 0.
            fade_out: How long a stop takes to become complete [s], >= 0.

        Raises:
            ArgumentError: As of `add`; also if clips step differently, or are alike, or do not
                reach the speed or the turn.
            SkeletonError: As of `add`.
            ClipError: As of `add`.
            SupportSequenceError: As of `add`.
        """
        self._check_new(name, fade_in, fade_out)
        values, clips = parse_priority(priority), tuple(clips)
        if not clips:
            raise ArgumentError(f"{name!r} has no clip; a locomotion needs at least one")
        with self._unchanged_if_refused():
            packs, cycles = self._packed_gaits(name, clips)
            rig = self.rig()
            gaits = Locomotion(cycles, rig.leg_sides, rig.leg_length)
            begin = gaits.checked(speed, turn)
            mix = gaits.mix(*begin)
        resting = np.einsum("c,cfp->fp", mix.shares, [p.resting_heights for _, p in packs])
        gait = tuple((clip, one[1]) for (clip, _), one in zip(packs, clips, strict=True))
        packed = packs[0][1]._replace(keys=mix.keys, roots=mix.roots, resting_heights=resting)
        self._additions.append(
            lambda other: other.add_locomotion(
                name,
                clips,
                speed=begin[0] * other.rig().leg_length / rig.leg_length,
                turn=begin[1],
                priority=priority,
                fade_in=fade_in,
                fade_out=fade_out,
            )
        )
        fades, first = (fade_in, fade_out), packs[0][0]
        self._actions.append(
            Action(name, first, mix.supports, values, *fades, packed, gaits, begin, gait)
        )
        return len(self._actions) - 1

    def _packed_gaits(
        self, name: str, clips: Sequence[tuple[Clip, SupportSequence]]
    ) -> tuple[list[tuple[Clip, PackedClip]], list[GaitCycle]]:
        packs: list[tuple[Clip, PackedClip]] = []
        cycles: list[GaitCycle] = []
        for index, (clip, supports) in enumerate(clips):
            label = f"clip {index} of {name!r}"
            packs.append(self._packed(label, clip, supports))
            packed, fps = packs[-1][1], packs[-1][0].fps
            cycles.append(GaitCycle.of(label, packed.keys, packed.roots, fps, supports))
        return packs, cycles

    def shelf(self, planner: Planner = "footfall") -> Shelf:
        """Return the library as the kernels take it.

        Raises:
            ArgumentError: If no clip has been added yet.
        """
        actions = self._actions
        if not actions or self._standing is None or self._resting is None:
            raise ArgumentError("the library is empty; add a clip first")
        rig, joints = self.rig(), self.skeleton.count
        keys = np.concatenate([*(action.packed.keys for action in actions), self._standing])
        sequences = [action.supports for action in actions]
        standing_root, points = np.zeros((1, 3)), rig.foot_points / rig.leg_length
        resting = [*(action.packed.resting_heights for action in actions), self._resting]
        packed = by_component(keys, joints)
        return Shelf(
            keys=packed,
            roots=np.concatenate([*(action.packed.roots for action in actions), standing_root]),
            sole_keys=sole_keys_of(packed, joints, points),
            entries=entries_of(actions),
            resting_heights=resting_octets(resting),
            table=SequenceTable.of(sequences),
            phase_starts=np.concatenate([one.boundaries[:-1] for one in sequences]),
            points=points,
            use_paper_cubic=planner == "paper",
            joints=joints,
            layers=layer_shelf_of(self._layers, joints),
        )
