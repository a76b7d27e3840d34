"""A motion that a program of the user's makes, instead of a file.

It is asked for all its poses at once, at a steady rate, when it is added to a library: the kernels
then play it as they play any clip, and nothing of the user's runs while time passes. What may go
wrong goes wrong there, and says whose action it was.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from footfall.arrays import Positions, Rotations, Seconds
from footfall.errors import ArgumentError, ClipError, SourceError
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.support import SupportSequence

__all__ = ["MotionSource", "ask_source"]

MOST_FRAMES = 1_000_000
"""More than this many poses are not asked for: a rate in the wrong unit fills the memory."""


class MotionSource(Protocol):
    """Anything that can say what a body does at a time: a procedure, or a lazily read archive."""

    @property
    def skeleton(self) -> Skeleton:
        """The body that moves."""
        ...

    @property
    def fps(self) -> float:
        """About how many poses a second are asked for, > 0."""
        ...

    @property
    def supports(self) -> SupportSequence:
        """What carries the body when; the motion lasts as long, and is cyclic if they are."""
        ...

    def poses(self, times: Seconds) -> tuple[Positions, Rotations]:
        """Return the poses at some times.

        Args:
            times: From 0 to the whole duration, both included [s], shape (times,). The pose at the
                end of a cyclic motion is the first one, one cycle's displacement further.

        Returns:
            Joint 0 in the world [m], shape (times, 3), and the rotations of joints relative to
            their parents, those of joint 0 relative to the world, shape (times, joints, 4).
        """
        ...


def ask_source(name: str, source: MotionSource) -> tuple[Clip, SupportSequence]:
    """Return all that a source has to give: its motion, and what it stands on.

    Args:
        name: The action that it is for.
        source: The user's program.

    Raises:
        SourceError: If it raises anything.
        ArgumentError: If its body, its rate or its supports are none.
        ClipError: If its poses are not as many as the times, or no poses.
    """
    try:
        skeleton, fps, supports = source.skeleton, source.fps, source.supports
    except Exception as error:
        raise SourceError(name, error) from error
    _check(name, "body", skeleton, Skeleton)
    _check(name, "supports", supports, SupportSequence)
    frames = _frames(name, fps, supports.duration)
    times = np.linspace(0.0, supports.duration, frames)
    try:
        given = source.poses(times.copy())
        positions, rotations = (np.array(part, dtype=np.float64) for part in given)
    except Exception as error:
        raise SourceError(name, error) from error
    if positions.shape != (frames, 3):
        raise ClipError(
            f"the source of {name!r} gave positions of shape {positions.shape} for {frames} "
            f"times; {(frames, 3)} is needed"
        )
    rate = (frames - 1) / supports.duration
    clip = Clip(skeleton, positions, rotations, rate, supports.cyclic, name, (WHENCE,))
    return clip, supports


WHENCE = "made by a motion source"
"""The provenance of such a clip."""


def _check(name: str, what: str, given: object, needed: type) -> None:
    if not isinstance(given, needed):
        raise ArgumentError(
            f"the {what} of the source of {name!r} is a {type(given).__name__}; "
            f"a {needed.__name__} is needed"
        )


def _frames(name: str, fps: object, duration: float) -> int:
    """Return how many poses are asked for."""
    if not (isinstance(fps, int | float) and math.isfinite(fps) and fps > 0.0):
        raise ArgumentError(f"the source of {name!r} has {fps!r} frames per second; > 0 is needed")
    if fps * duration > MOST_FRAMES:
        raise ArgumentError(
            f"the source of {name!r} has {fps:g} frames per second for {duration:g} s; at most "
            f"{MOST_FRAMES} frames are kept"
        )
    return max(round(fps * duration), 1) + 1
