"""The samples by name."""

from __future__ import annotations

from functools import lru_cache

from footfall.errors import ArgumentError, UnknownNameError
from footfall.motion import Clip
from footfall.samples.bends import bent
from footfall.samples.cycle import perform
from footfall.samples.jump import JUMP
from footfall.samples.kick import KICK
from footfall.samples.locomotion import OTHER_GAITS
from footfall.samples.punch import PUNCH
from footfall.samples.score import play
from footfall.samples.shot import SHOT
from footfall.samples.walk_to_hop import WALK_TO_HOP
from footfall.samples.walks import WALKS
from footfall.support import SupportSequence

__all__ = ["sample", "sample_names"]

_LOWEST_RATE = 10.0

_STRAIGHT = {**WALKS, **OTHER_GAITS}

_TURN_RATE = 0.65
"""Of the gaits in a curve [rad/s]: a walk goes round a circle of 2 m, a run round one of 5 m."""

_CURVES = {
    f"{name}-{side}": bent(_STRAIGHT[name], sign * _TURN_RATE * _STRAIGHT[name].duration)
    for name in ("walk", "run")
    for side, sign in (("left", 1.0), ("right", -1.0))
}

_GAITS = {**_STRAIGHT, **_CURVES}

_SCORES = {"kick": KICK, "punch": PUNCH, "jump": JUMP, "shot": SHOT, "walk-to-hop": WALK_TO_HOP}


def sample_names() -> tuple[str, ...]:
    """Return the names of all samples."""
    return (*_GAITS, *_SCORES)


def sample(name: str, *, fps: float = 60.0) -> tuple[Clip, SupportSequence]:
    """Return a motion made by the project itself, and the supports it was made with.

    The supports are not measured: the motion is built on them, so they are exact. Cyclic
    samples last a whole number of frames; the others end on the last frame that fits.

    Args:
        name: One of `sample_names`.
        fps: Frames per second, at least 10.

    Raises:
        UnknownNameError: If there is no such sample.
        ArgumentError: If `fps` is below 10 or not finite.
    """
    if name not in sample_names():
        raise UnknownNameError("sample", name, sample_names())
    if not _LOWEST_RATE <= fps < float("inf"):
        raise ArgumentError(f"fps is {fps}; a sample needs at least {_LOWEST_RATE:g} per second")
    return _made(name, float(fps))


@lru_cache(maxsize=64)
def _made(name: str, fps: float) -> tuple[Clip, SupportSequence]:
    if name in _GAITS:
        return perform(_GAITS[name], name, fps)
    return play(_SCORES[name], name, fps)
