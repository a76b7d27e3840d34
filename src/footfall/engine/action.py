"""One action of a motion library: a clip, or a gait that follows parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from footfall.actions import Locomotion
from footfall.arrays import Floats
from footfall.compilation import records
from footfall.engine.entry import entry_type
from footfall.engine.packing import PackedClip
from footfall.errors import ClipError
from footfall.motion import Clip
from footfall.support import SupportSequence
from footfall.sync.tables import check_registration

__all__ = ["LONGEST_DISAGREEMENT", "Action", "check_supports", "entries_of"]

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

    locomotion: Locomotion | None = None
    """The cycles it mixes, where it follows parameters: `clip` is then the first of them, and
    `packed` and `supports` what they are at the speed and turn with which it begins."""

    parameters: tuple[float, float] = (0.0, 0.0)
    """That speed [m/s] and turn [rad/s]."""

    gait: tuple[tuple[Clip, SupportSequence], ...] = ()
    """The clips of `locomotion`, and what each stands on."""

    @property
    def duration(self) -> float:
        """From the first frame of `packed` to the last one [s]."""
        return self.clip.duration if self.locomotion is None else self.supports.duration

    @property
    def fps(self) -> float:
        """Frames of `packed` per second."""
        if self.locomotion is None:
            return self.clip.fps
        return (len(self.packed.keys) - 1) / self.supports.duration


def check_supports(label: str, clip: Clip, supports: SupportSequence) -> None:
    """Refuse supports that do not fit a clip; errors as of `MotionLibrary.add`."""
    check_registration(supports)
    if supports.cyclic != clip.cyclic:
        kinds = {True: "cyclic", False: "once"}
        raise ClipError(
            f"the clip of {label} is {kinds[clip.cyclic]}, its supports are "
            f"{kinds[supports.cyclic]}; both must be the same"
        )
    if abs(supports.duration - clip.duration) > LONGEST_DISAGREEMENT:
        raise ClipError(
            f"the clip of {label} lasts {clip.duration:.3f} s, its supports "
            f"{supports.duration:.3f} s; both must last the same"
        )


def entries_of(actions: Sequence[Action]) -> Any:
    """Return one record an action, in their order."""
    entries = records(np.zeros(len(actions), dtype=entry_type))
    frame = phase = 0
    for entry, action in zip(entries, actions, strict=True):
        frames, count = len(action.packed.keys), len(action.supports.phases)
        entry["first_frame"], entry["frame_count"] = frame, frames
        entry["fps"], entry["duration"] = action.fps, action.duration
        entry["cyclic"] = action.supports.cyclic
        entry["phase_first"], entry["phase_count"] = phase, count
        entry["priorities"] = action.priority
        entry["fade_in"], entry["fade_out"] = action.fade_in, action.fade_out
        frame, phase = frame + frames, phase + count
    return entries
