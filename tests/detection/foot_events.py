"""Strikes and releases of each foot: what detected and true supports are compared by."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.detection.pinning import foot_spans
from footfall.geometry import from_axis_angle, multiply
from footfall.motion import Clip
from footfall.skeleton import find_anatomy
from footfall.support import SupportSequence

Events = list[tuple[str, float]]


def foot_events(supports: SupportSequence, foot: int) -> Events:
    """Return the strikes and releases of a foot, without the clip's own ends, in order."""
    if supports.cyclic and all(
        p.support.right if foot else p.support.left for p in supports.phases
    ):
        return []
    events: Events = []
    for span in foot_spans(supports, foot):
        for kind, time in (("strike", span.start), ("release", span.end)):
            if supports.cyclic:
                events.append((kind, time % supports.duration))
            elif 0.02 < time < supports.duration - 0.02:
                events.append((kind, time))
    return sorted(events, key=lambda event: event[1])


def worst_error(expected: SupportSequence, found: SupportSequence) -> float:
    """Return the greatest distance of a found event from the true one [s].

    Infinite where the numbers of strikes and releases differ.
    """
    worst = 0.0
    duration = expected.duration
    for foot in range(2):
        one, other = foot_events(expected, foot), foot_events(found, foot)
        if sorted(k for k, _ in one) != sorted(k for k, _ in other):
            return np.inf
        for kind, time in one:
            gaps = [abs(t - time) for k, t in other if k == kind]
            if expected.cyclic:
                gaps = [min(gap, duration - gap) for gap in gaps]
            worst = max(worst, min(gaps))
    return worst


def noisy(clip: Clip, deviation: float, seed: int) -> Clip:
    """Return the clip with each foot about so far from its place in each frame [m].

    One half comes from where the pelvis is, the other from how the legs are turned.
    """
    random = np.random.default_rng(seed)
    pelvis: Positions = clip.pelvis_positions + random.normal(
        0.0, deviation * np.sqrt(0.5), clip.pelvis_positions.shape
    )
    local: Rotations = np.array(clip.local_rotations)
    for leg in find_anatomy(clip.skeleton).legs:
        for joint, below in ((leg.hip, 0.85), (leg.knee, 0.43)):
            for axis in np.eye(3)[[0, 2]]:
                angle = random.normal(0.0, 0.5 * deviation / below, clip.frames)
                turn = from_axis_angle(np.broadcast_to(axis, (clip.frames, 3)), angle)
                local[:, joint] = multiply(local[:, joint], turn)
    if clip.cyclic:
        pelvis[-1] = clip.pelvis_positions[-1] + pelvis[0] - clip.pelvis_positions[0]
        local[-1, 1:] = local[0, 1:]
    return clip.evolve(pelvis_positions=pelvis, local_rotations=local)
