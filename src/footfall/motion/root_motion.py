"""The way of a body over the ground, apart from the body.

The root stands on the ground under the pelvis. It turns smoothly and slowly: the pelvis itself
swings to and fro with every step, and a root that swung with it would drag the planted feet of
every motion it is mixed with.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, frozen
from footfall.geometry import transforms
from footfall.motion.clip import Clip
from footfall.skeleton import Anatomy, pelvis_headings

__all__ = ["RootPath", "extract_root_path", "smooth_headings"]

HEADING_CUTOFF = 0.7
"""Frequency above which the pelvis' heading is no turn of the body [Hz]. Strides take 0.9 to
1.3 s, so that their swing, near 1 Hz, keeps a fifth of its size; a turn that takes two seconds
keeps nine tenths of its."""

FILTER_ORDER = 4
"""Steepness: a second-order Butterworth filter passed forward and backward."""


@dataclass(frozen=True, eq=False)
class RootPath:
    """Where the root is in each frame."""

    positions: Floats
    """x and z under the pelvis [m], shape (frames, 2)."""

    headings: Floats
    """Smooth yaw [rad], 0 facing +z, positive from z towards x, unwrapped, shape (frames,)."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "positions", frozen(self.positions))
        object.__setattr__(self, "headings", frozen(self.headings))

    @property
    def displacement(self) -> tuple[float, float, float]:
        """The last frame's root as seen from the first one's: x, z [m], heading [rad]."""
        first, last = self.positions[0], self.positions[-1]
        x, z, heading = transforms.relative(
            float(first[0]),
            float(first[1]),
            float(self.headings[0]),
            float(last[0]),
            float(last[1]),
            float(self.headings[-1]),
        )
        return (float(x), float(z), float(heading))


def extract_root_path(clip: Clip, anatomy: Anatomy) -> RootPath:
    """Return the way of a clip over the ground.

    Over a cycle the heading is linear, so that one planar displacement leads from any frame to
    the same frame of the next cycle. Elsewhere it is the pelvis' heading, low-passed without
    delay.

    Args:
        clip: The motion.
        anatomy: Which joints its hips are.

    Returns:
        The root in each frame of the clip.
    """
    _, positions = clip.world_poses()
    headings = pelvis_headings(anatomy, positions)
    if clip.cyclic:
        line = _ramp(clip.frames) * float(headings[-1] - headings[0])
        headings = line + float((headings - line)[:-1].mean())
    else:
        headings = smooth_headings(headings, clip.fps)
    return RootPath(clip.pelvis_positions[:, [0, 2]], headings)


def smooth_headings(headings: Floats, fps: float) -> Floats:
    """Return headings without the swing of the steps.

    A zero-phase low-pass. Beyond each end the heading is taken to stay: that lets through half of
    a swing that is cut there, and half of a turn, where a continued turn would let through all
    of the swing, and a mirrored one none of the turn.

    Args:
        headings: Unwrapped headings [rad], shape (frames,).
        fps: Frames per second.

    Returns:
        Smooth headings [rad], shape (frames,).
    """
    count = len(headings)
    margin = max(1, round(fps / HEADING_CUTOFF))
    padded = np.pad(headings, margin, mode="edge")
    line = padded[0] + _ramp(len(padded)) * float(padded[-1] - padded[0])
    rest = padded - line
    # A sum of sines, each scaled by the filter's gain: nothing wraps around.
    odd = np.concatenate([rest, -rest[-2:0:-1]])
    frequencies = np.fft.rfftfreq(len(odd), 1.0 / fps)
    gain = 1.0 / (1.0 + (frequencies / HEADING_CUTOFF) ** FILTER_ORDER)
    smooth: Floats = np.fft.irfft(gain * np.fft.rfft(odd), len(odd))
    return (line + smooth[: len(padded)])[margin : margin + count]


def _ramp(count: int) -> Floats:
    """Return evenly spaced numbers from 0 to 1."""
    return np.arange(count, dtype=np.float64) / (count - 1)
