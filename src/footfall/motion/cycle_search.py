"""Find one clean cycle in a long clip.

Two frames with nearly the same pose are not enough: standing has many of those. A gait cycle
holds exactly one swing of each foot, and its ends agree in pose and in velocity, once the
beginning is moved over the ground onto the end.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Flags, Indices, Positions
from footfall.errors import ClipError
from footfall.geometry import from_yaw, rotate
from footfall.motion.clip import Clip
from footfall.motion.gait import foot_point_paths, foot_speeds, swinging
from footfall.motion.ground_alignment import align_on_ground
from footfall.skeleton import Anatomy, leg_length

__all__ = ["Cycle", "find_cycle", "main_joints"]

SHORTEST_CYCLE = 0.35
"""Shortest cycle that is looked for [s]; sprinters take 0.45 s."""

LONGEST_CYCLE = 3.0
"""Longest cycle that is looked for [s]; a creeping walk takes 2 s."""

VELOCITY_WEIGHT = 0.06
"""Time [s] by which differences of velocity count beside those of place: two frames of 30 fps,
about what it takes to see a jerk."""

GREATEST_MISMATCH = 0.12
"""Mismatch of the ends, as a share of the leg's length, beyond which a stretch is no cycle."""

SEARCH_RATE = 30.0
"""Frames per second at which pairs are first compared; the best one is refined at full rate."""


class Cycle(NamedTuple):
    """One cycle of a clip."""

    start: int
    """Its first frame."""

    end: int
    """The frame on which it begins anew."""

    mismatch: float
    """Distance of the joints between both, the first moved over the ground onto the last, root
    mean square [m]."""


def find_cycle(clip: Clip, anatomy: Anatomy) -> Cycle:
    """Return the stretch of a clip that is best fit to be repeated.

    Args:
        clip: The motion; of a cyclic one it is all.
        anatomy: Which joints its legs are.

    Raises:
        ClipError: If no stretch of a plausible duration holds exactly one swing of each foot, or
            the ends of all that do differ too much.
    """
    rotations, positions = clip.world_poses()
    places = positions[:, main_joints(anatomy)]
    if clip.cyclic:
        return Cycle(0, clip.frames - 1, _mismatch(places, 0, clip.frames - 1))
    points = foot_point_paths(anatomy, rotations, positions)
    speeds = foot_speeds(points, positions[:, 0], clip.fps)
    swings = np.stack([swinging(speeds[:, foot]) for foot in range(2)], axis=1)
    best = _best_pair(places, swings, clip.fps)
    if best is None:
        starts = np.count_nonzero(swings[1:] & ~swings[:-1], axis=0)
        raise ClipError(
            f"clip {clip.name!r} has no cycle: no stretch of {SHORTEST_CYCLE:g} to "
            f"{LONGEST_CYCLE:g} s holds exactly one swing of each foot; in its "
            f"{clip.duration:.2f} s the left foot begins {starts[0]} swings, the right one "
            f"{starts[1]}"
        )
    start, end = best
    mismatch = _mismatch(places, start, end)
    most = GREATEST_MISMATCH * max(leg_length(clip.skeleton, leg) for leg in anatomy.legs)
    if mismatch > most:
        raise ClipError(
            f"clip {clip.name!r} has no cycle: its best stretch, frames {start} to {end}, ends "
            f"{1000 * mismatch:.0f} mm away from its beginning; at most {1000 * most:.0f} mm can "
            "be closed"
        )
    return Cycle(start, end, mismatch)


def main_joints(anatomy: Anatomy) -> list[int]:
    """Return pelvis, hips, knees, ankles, toes, chest, head, shoulders, elbows and wrists."""
    joints: list[int] = [0]
    for leg in anatomy.legs:
        joints += [leg.hip, leg.knee, leg.ankle, leg.toe.joint]
    for arm in anatomy.arms:
        joints += [] if arm is None else [arm.shoulder, arm.elbow, arm.wrist]
    joints += [joint for joint in (anatomy.chest, anatomy.head) if joint is not None]
    return sorted(set(joints))


def _mismatch(places: Positions, start: int, end: int) -> float:
    _, _, apart = align_on_ground(places[start], places[end])
    return float(np.sqrt((apart**2).sum(axis=-1).mean()))


def _best_pair(places: Positions, swings: Flags, fps: float) -> tuple[int, int] | None:
    """Return the pair of frames that differs least and bounds one cycle, or None."""
    velocities = VELOCITY_WEIGHT * np.gradient(places, 1.0 / fps, axis=0)
    step = max(1, round(fps / SEARCH_RATE))
    shortest = max(2, round(SHORTEST_CYCLE * fps / step))
    longest = round(LONGEST_CYCLE * fps / step)
    starts = np.arange(0, len(places), step)
    lags = step * np.arange(shortest, longest + 1)
    coarse = _least(places, velocities, swings, starts, lags)
    if coarse is None or step == 1:
        return coarse
    near = np.arange(max(coarse[0] - step, 0), coarse[0] + step + 1)
    lags = np.arange(coarse[1] - coarse[0] - step, coarse[1] - coarse[0] + step + 1)
    return _least(places, velocities, swings, near, lags)


def _least(
    places: Positions, velocities: Positions, swings: Flags, starts: Indices, lags: Indices
) -> tuple[int, int] | None:
    """Return the best of the pairs with these first frames and these distances, or None."""
    best: tuple[float, int, int] | None = None
    for lag in lags:
        first = starts[starts + lag < len(places)]
        first = first[_one_cycle(swings, first, first + int(lag))]
        if len(first) == 0:
            continue
        yaws, _, apart = align_on_ground(places[first], places[first + lag])
        turned = rotate(from_yaw(yaws)[:, np.newaxis], velocities[first])
        jerk = velocities[first + lag] - turned
        costs = (apart**2).sum(axis=(1, 2)) + (jerk**2).sum(axis=(1, 2))
        least = int(np.argmin(costs))
        if best is None or costs[least] < best[0]:
            best = (float(costs[least]), int(first[least]), int(first[least] + lag))
    return None if best is None else best[1:]


def _one_cycle(swings: Flags, starts: Indices, ends: Indices) -> Flags:
    """Return which stretches hold one swing of each foot, or of one while the other flies.

    A swing that is cut by the ends is one swing, since the stretch goes around.
    """
    begins = np.zeros(swings.shape, dtype=np.int64)
    begins[1:] = swings[1:] & ~swings[:-1]
    begun = np.cumsum(begins, axis=0)
    flown = np.cumsum(np.concatenate([np.zeros((1, 2), np.int64), swings]), axis=0)
    around = swings[starts] & ~swings[ends - 1]
    counts = begun[ends - 1] - begun[starts] + around
    flying = flown[ends] - flown[starts] == (ends - starts)[:, np.newaxis]
    one = counts == 1
    return one.any(axis=1) & (one | flying).all(axis=1)
