"""Cut a clip, or give it another frame rate: each edit returns a new clip that says so."""

from __future__ import annotations

import math

import numpy as np

from footfall.errors import ArgumentError
from footfall.motion.clip import Clip
from footfall.motion.sampling import sample

__all__ = ["crop", "crop_frames", "resample"]

_NEARLY = 1e-6
"""Share of a frame by which a time may miss it and still mean it."""


def crop(clip: Clip, start: float, end: float) -> Clip:
    """Return the frames of a clip within two times, both included.

    The new clip begins at time 0 and is not cyclic.

    Args:
        clip: The motion.
        start: First time [s], within the clip.
        end: Last time [s], after `start` and within the clip.

    Raises:
        ArgumentError: If a time is not within the clip, or no frame lies between them.
    """
    for label, time in (("start", start), ("end", end)):
        if not (math.isfinite(time) and -_NEARLY <= time * clip.fps <= clip.frames - 1 + _NEARLY):
            raise ArgumentError(
                f"clip {clip.name!r}: the crop's {label} is {time:g} s; it must be within "
                f"0..{clip.duration:g} s"
            )
    if not start < end:
        raise ArgumentError(
            f"clip {clip.name!r}: the crop starts at {start:g} s and ends at {end:g} s; "
            "it must end after its start"
        )
    first = math.ceil(start * clip.fps - _NEARLY)
    last = math.floor(end * clip.fps + _NEARLY)
    if last < first:
        raise ArgumentError(
            f"clip {clip.name!r}: no frame lies within {start:g}..{end:g} s; "
            f"frames are {1.0 / clip.fps:g} s apart"
        )
    return crop_frames(clip, first, last)


def crop_frames(clip: Clip, first: int, last: int) -> Clip:
    """Return the frames `first` to `last` of a clip, both included; it is not cyclic.

    Raises:
        ArgumentError: If 0 <= first <= last < frames does not hold.
    """
    if not 0 <= first <= last < clip.frames:
        raise ArgumentError(
            f"clip {clip.name!r}: frames {first} to {last} are not within 0..{clip.frames - 1}"
        )
    return clip.evolve(
        pelvis_positions=clip.pelvis_positions[first : last + 1],
        local_rotations=clip.local_rotations[first : last + 1],
        cyclic=False,
        because=f"cropped to frames {first} to {last} of {clip.frames} "
        f"({first / clip.fps:.3f} to {last / clip.fps:.3f} s)",
    )


def resample(clip: Clip, fps: float) -> Clip:
    """Return a clip at another frame rate.

    A cyclic clip keeps its first and last frame: where its duration is no whole number of the new
    frames, it is stretched to the nearest one, by at most half a frame. Another clip keeps its
    speed and loses what lies after the last whole frame.

    Args:
        clip: The motion.
        fps: Frames per second, > 0.

    Raises:
        ArgumentError: If the rate is not positive, or a cycle would last less than one frame.
    """
    if not (math.isfinite(fps) and fps > 0.0):
        raise ArgumentError(f"clip {clip.name!r}: a rate of {fps:g} frames per second; needs > 0")
    steps = clip.duration * fps
    count = round(steps) if clip.cyclic else math.floor(steps + _NEARLY)
    if clip.cyclic and count < 1:
        raise ArgumentError(
            f"clip {clip.name!r}: a cycle of {clip.duration:g} s has no frame at {fps:g} frames "
            f"per second; at least {1.0 / clip.duration:g} are needed"
        )
    times = np.arange(count + 1, dtype=np.float64) / fps
    because = f"resampled from {clip.fps:g} to {fps:g} frames per second"
    if clip.cyclic:
        times *= clip.duration * fps / count
        if abs(steps - count) > _NEARLY:
            because += f", its cycle stretched by {(count / steps - 1.0):+.2%}"
    positions, rotations = sample(clip, np.minimum(times, clip.duration))
    if clip.cyclic:
        positions[-1], rotations[-1] = clip.pelvis_positions[-1], clip.local_rotations[-1]
    return clip.evolve(
        pelvis_positions=positions, local_rotations=rotations, fps=fps, because=because
    )
