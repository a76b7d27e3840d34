"""A trace at 60 Hz, reduced to what the measures need.

A measure must not depend on the frame rate of what it measures, so everything is brought to one
rate before anything is computed: positions linearly, labels by the nearest frame. The points of
the feet are found first and then resampled, so that no rotation has to be.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from footfall.arrays import Flags, Floats, Positions, Seconds, Supports
from footfall.geometry import rotate
from footfall.report.trace import Trace
from footfall.support import Support

__all__ = ["RATE", "Track", "carrying", "frame_times", "resampled", "resampled_labels"]

Label = TypeVar("Label", bound=np.generic)

RATE = 60.0
"""The rate at which everything is measured [frames/s] (measures, section 1)."""

CONTACT_SHARE = 0.05
"""Contact height over leg length: about 4 cm, which told contacts rightly on all clips tried
(measures, section 4)."""

RESTING_PERCENTILE = 5.0
"""Which percentile of a point's heights is its resting level (measures, section 4)."""

STEADY = 1e-6
"""Shares that change by less than this between two frames stand still."""


@dataclass(frozen=True, eq=False)
class Track:
    """A motion at 60 Hz: joints, feet, surface, and the labels of each frame."""

    joints: Positions
    """All joints in the world [m], shape (frames, joints, 3)."""

    points: Positions
    """Heel and toe of the left and the right foot in the world [m], shape (frames, 2, 2, 3)."""

    heights: Floats
    """Those points over the surface under them [m], shape (frames, 2, 2)."""

    surface_displacement: Positions
    """How far the surface under them has moved since the first frame [m], (frames, 2, 2, 3)."""

    resting_levels: Floats
    """Their heights over the surface at rest [m], shape (2, 2)."""

    contact_heights: Floats
    """Below this much over its resting level a point is in contact [m], shape (2, 1)."""

    supports: Supports
    """The commanded support, shape (frames,)."""

    shares: Floats
    """Share of each action in the legs, shape (frames, actions)."""

    moving: Flags
    """Whether weights move, shape (frames,)."""

    rates: Floats
    """Clip time per clock time, shape (frames,)."""

    ankles: Positions
    """The ankle joints in the world [m], shape (frames, 2, 3)."""

    @classmethod
    def from_trace(cls, trace: Trace) -> Track:
        """Resample a trace to 60 Hz and find its feet and its surface."""
        fps = trace.fps
        points = resampled(_foot_points(trace), fps)
        times = frame_times(trace.frames, fps)
        heights = points[..., 1] - _surface(trace, points, times)
        contact_heights = _contact_heights(trace)
        resting = trace.resting_levels
        if resting is None:
            resting = _resting_levels(heights, contact_heights)
        one_action = np.ones((trace.frames, 1))
        shares = one_action if trace.shares is None else trace.shares
        joints = resampled(trace.positions, fps)
        return cls(
            joints=joints,
            points=points,
            heights=heights,
            surface_displacement=_displacement(trace, points.shape),
            resting_levels=resting,
            contact_heights=contact_heights,
            supports=resampled_labels(trace.supports, fps),
            shares=resampled_labels(shares, fps),
            moving=resampled_labels(_moving(trace, shares), fps),
            rates=np.ones(len(times)) if trace.rates is None else resampled(trace.rates, fps),
            ankles=joints[:, [leg.ankle for leg in trace.anatomy.legs]],
        )

    @property
    def frames(self) -> int:
        """How many frames there are at 60 Hz."""
        return len(self.points)

    @cached_property
    def clearances(self) -> Floats:
        """Heights of the foot points over their resting levels [m], shape (frames, 2, 2)."""
        return self.heights - self.resting_levels

    @cached_property
    def contacts(self) -> Flags:
        """Whether a foot point is low enough to carry, shape (frames, 2, 2)."""
        return self.clearances < self.contact_heights

    @cached_property
    def places(self) -> Floats:
        """Where the foot points are on their surface: x and z [m], shape (frames, 2, 2, 2)."""
        return (self.points - self.surface_displacement)[..., [0, 2]]


def frame_times(frames: int, fps: float) -> Seconds:
    """Return the times [s] of the 60 Hz frames that `frames` at `fps` span, shape (n,)."""
    count = math.floor((frames - 1) / fps * RATE + 1e-6) + 1
    return np.arange(count) / RATE


def resampled(values: Floats, fps: float) -> Floats:
    """Return values at 60 Hz, linearly between the frames at `fps`, shape (frames, ...)."""
    if fps == RATE:
        return np.asarray(values, dtype=np.float64)
    at = frame_times(len(values), fps) * fps
    before = np.minimum(np.floor(at + 1e-9).astype(np.int64), len(values) - 1)
    after = np.minimum(before + 1, len(values) - 1)
    share = np.maximum(at - before, 0.0).reshape((-1,) + (1,) * (values.ndim - 1))
    return (1.0 - share) * values[before] + share * values[after]


def resampled_labels(labels: npt.NDArray[Label], fps: float) -> npt.NDArray[Label]:
    """Return the label of the nearest frame at 60 Hz, the later of two, shape (frames, ...)."""
    nearest = np.floor(frame_times(len(labels), fps) * fps + 0.5 + 1e-9).astype(np.int64)
    return labels[np.minimum(nearest, len(labels) - 1)]


def carrying(supports: Supports) -> Flags:
    """Return whether each foot carries, shape (..., 2): left, right. In a CONFLICT none does."""
    single = supports[..., np.newaxis] == np.array([Support.LEFT, Support.RIGHT])
    return single | (supports[..., np.newaxis] == Support.DOUBLE)


def _foot_points(trace: Trace) -> Positions:
    feet = [(leg.heel, leg.toe) for leg in trace.anatomy.legs]
    joints = np.array([[point.joint for point in foot] for foot in feet])
    offsets = np.array([[point.offset for point in foot] for foot in feet])
    return trace.positions[:, joints] + rotate(trace.rotations[:, joints], offsets)


def _surface(trace: Trace, points: Positions, times: Seconds) -> Floats:
    if callable(trace.ground):
        return trace.ground(points, np.broadcast_to(times[:, None, None], points.shape[:-1]))
    if isinstance(trace.ground, np.ndarray) and trace.ground.ndim:
        return resampled(trace.ground, trace.fps)
    return np.full(points.shape[:-1], float(trace.ground))


def _displacement(trace: Trace, shape: tuple[int, ...]) -> Positions:
    if trace.surface_displacement is None:
        return np.zeros(shape)
    moved = resampled(trace.surface_displacement, trace.fps)
    return np.broadcast_to(moved[:, None, None] if moved.ndim == 2 else moved, shape)


def _contact_heights(trace: Trace) -> Floats:
    if trace.contact_height is not None:
        return np.full((2, 1), trace.contact_height)
    first = trace.positions[0]
    chains = np.array([(leg.hip, leg.knee, leg.ankle) for leg in trace.anatomy.legs])
    lengths = np.linalg.norm(np.diff(first[chains], axis=1), axis=-1).sum(axis=1)
    return CONTACT_SHARE * lengths[:, np.newaxis]


def _resting_levels(heights: Floats, contact_heights: Floats) -> Floats:
    levels = np.asarray(np.percentile(heights, RESTING_PERCENTILE, axis=0))
    # A foot that is never down rests where the other one does.
    return np.minimum(levels, levels.min(axis=0) + contact_heights)


def _moving(trace: Trace, shares: Floats) -> Flags:
    if trace.moving is not None:
        return trace.moving
    changed = np.abs(np.diff(shares, axis=0)).max(axis=1) > STEADY
    return np.concatenate([changed, [False]]) | np.concatenate([[False], changed])
