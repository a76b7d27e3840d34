"""A performance, or any recording, as the measures see it."""

from __future__ import annotations

import numpy as np

from footfall.adaptation import Plane, ground_heights
from footfall.arrays import Floats, Positions, Supports
from footfall.engine.recording import Recording
from footfall.geometry import rotate
from footfall.report.trace import SurfaceHeights, Trace
from footfall.scenario.performance import Performance
from footfall.skeleton import Anatomy

__all__ = ["performance_trace", "recording_trace"]


def performance_trace(performance: Performance) -> Trace:
    """Return a performance as the measures see it; the neutral motion is the last share."""
    positions, ground, displacement = _on_its_ground(performance)
    return recording_trace(
        performance.recording,
        performance.anatomy,
        supports=performance.supports,
        positions=positions,
        ground=ground,
        surface_displacement=displacement,
    )


def recording_trace(
    recording: Recording,
    anatomy: Anatomy,
    *,
    supports: Supports | None = None,
    positions: Positions | None = None,
    ground: SurfaceHeights | Floats | float = 0.0,
    surface_displacement: Positions | None = None,
) -> Trace:
    """Return a recording as the measures see it; the neutral motion is the last share.

    Args:
        recording: What a character did.
        anatomy: Its body's, the heels on the soles.
        supports: What was commanded to carry it, shape (frames,); None: as recorded.
        positions: Where its joints are [m], (frames, joints, 3); None: as recorded.
        ground: As in `Trace`.
        surface_displacement: As in `Trace`.
    """
    resting = np.clip(1.0 - recording.shares.sum(axis=1, keepdims=True), 0.0, 1.0)
    shares = np.concatenate([recording.shares, resting], axis=1)
    shares /= shares.sum(axis=1, keepdims=True)
    return Trace(
        positions=recording.world_positions if positions is None else positions,
        rotations=recording.world_rotations,
        anatomy=anatomy,
        fps=recording.fps,
        supports=recording.supports if supports is None else supports,
        shares=shares,
        moving=recording.moving,
        rates=_mean_rates(recording.rates, recording.shares),
        ground=ground,
        surface_displacement=surface_displacement,
    )


def _on_its_ground(
    performance: Performance,
) -> tuple[Positions, Floats | float, Positions | None]:
    """Return the joints, the ground, and how it has moved, as a trace has them."""
    recording = performance.recording
    positions = recording.world_positions.copy()
    if all(isinstance(one, Plane) and one.slope == (0.0, 0.0) for one in performance.grounds):
        # Level ground that rises is seen from itself: it stays where it was.
        positions[..., 1] -= performance.lifts[:, np.newaxis]
        return positions, performance.ground, None
    legs = performance.anatomy.legs
    joints = np.array([[leg.heel.joint, leg.toe.joint] for leg in legs])
    offsets = np.array([[leg.heel.offset, leg.toe.offset] for leg in legs])
    points = positions[:, joints] + rotate(recording.world_rotations[:, joints], offsets)
    heights = [
        ground_heights(ground, points[frame], np.full((2, 2), frame / recording.fps))
        for frame, ground in enumerate(performance.grounds)
    ]
    carried = np.repeat(recording.carried[:, :, np.newaxis], 2, axis=2)
    return positions, np.stack(heights), carried


def _mean_rates(rates: Floats, shares: Floats) -> Floats:
    """Return the weighted mean rate of what plays, 1 where nothing does, shape (frames,).

    A clip that is over plays no more: what still moves there is the fade.
    """
    weights = np.where(np.isfinite(rates) & (rates > 0.0), shares, 0.0)
    total = weights.sum(axis=1)
    summed = (np.nan_to_num(rates) * weights).sum(axis=1)
    return np.where(total > 1e-9, summed / np.where(total > 1e-9, total, 1.0), 1.0)
