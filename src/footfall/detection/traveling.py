"""Let a motion captured in place travel: its carrying foot takes it along.

Characters of games, and people on treadmills, walk where they are, and the ground runs backward
under them. Seen from that ground the body travels: from frame to frame it goes as far as the point
that carries it goes backward.
"""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.detection.phases import detect_supports, frame_symbols
from footfall.detection.tracks import foot_tracks, points_of_pose
from footfall.errors import ClipError
from footfall.motion import Clip, with_soles
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import SupportSequence

__all__ = ["travel"]


def travel(
    clip: Clip, supports: SupportSequence | None = None, anatomy: Anatomy | None = None
) -> Clip:
    """Return a motion captured in place as it goes over the ground.

    Only joint 0 moves, and only horizontally. While nothing carries, it goes on evenly from how
    it left the ground to how it comes back.

    Args:
        clip: The motion.
        supports: Its support phases; detected where not given, which asks for ground that runs
            about evenly (a side-step whose pelvis is held slides by 32 mm then).
        anatomy: Its skeleton's; found where not given.

    Returns:
        The clip, its provenance telling of it; its supports are what they were.

    Raises:
        ClipError: If the ground does not run under the clip's feet: it goes by itself, or stands.
        SkeletonError: If the body has no legs.
    """
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    belt = foot_tracks(clip, anatomy).belt_velocity
    if belt == (0.0, 0.0):
        raise ClipError(
            f"clip {clip.name!r} is not in place: the ground does not run under its feet faster "
            "than the body goes; only what was captured in place can be taken along"
        )
    supports = detect_supports(clip, anatomy) if supports is None else supports
    steps = _steps(clip, anatomy, supports, np.array(belt) / clip.fps)
    path = np.zeros((clip.frames, 3))
    path[1:, [0, 2]] = np.cumsum(steps, axis=0)
    way = float(np.linalg.norm(path[-1]))
    return clip.evolve(
        pelvis_positions=clip.pelvis_positions + path,
        because=f"taken along by its carrying feet, {way:.3f} m at {way / clip.duration:.2f} m/s; "
        f"the ground ran under it at {math.hypot(*belt):.2f} m/s",
    )


def _steps(clip: Clip, anatomy: Anatomy, supports: SupportSequence, expected: Floats) -> Floats:
    """Return how far the body goes from each frame to the next (x, z) [m], (frames - 1, 2).

    Args:
        clip: The motion.
        anatomy: Its skeleton's.
        supports: Its support phases.
        expected: How far the ground runs from frame to frame (x, z) [m]: of all points of the
            carrying feet the one that goes most like it is the one that rests.
    """
    poses = clip.world_poses()
    points = points_of_pose(*poses, with_soles(anatomy, *poses))[..., [0, 2]]
    moves = np.diff(points, axis=0)
    astray = np.linalg.norm(moves - expected, axis=-1)
    astray[~_carrying(clip, supports)] = np.inf
    flat = astray.reshape(len(moves), -1)
    resting = flat.argmin(axis=1)
    rows = np.arange(len(moves))
    known = np.isfinite(flat[rows, resting])
    steps = -moves.reshape(len(moves), -1, 2)[rows, resting]
    for axis in range(2):
        steps[~known, axis] = np.interp(
            rows[~known], rows[known], steps[known, axis], period=len(rows) if clip.cyclic else None
        )
    return steps


def _carrying(clip: Clip, supports: SupportSequence) -> Flags:
    """Return which foot carries from each frame to the next, shape (frames - 1, feet).

    Where no foot carries throughout such a step, one that does at its start or its end counts.
    """
    symbols = np.array(list(frame_symbols(supports, clip.fps, clip.frames)))
    carries = np.stack([np.isin(symbols, [foot, "D"]) for foot in "LR"], axis=1)
    both = carries[:-1] & carries[1:]
    handed_over = ~both.any(axis=1) & carries[:-1].any(axis=1) & carries[1:].any(axis=1)
    both[handed_over] = (carries[:-1] | carries[1:])[handed_over]
    return both
