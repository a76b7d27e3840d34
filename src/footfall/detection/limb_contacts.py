"""When each of four limbs carries: feet or knees, hands or forearms (section 4.2, section 7).

A foot rests at its own lowest place, whatever joint stands for it; a hand that is never put down
has a lowest place too. So these points rest only where that is near the floor, the lowest place
that any point of the body keeps to. A body that no limb carries, but whose trunk is on the floor,
does not fly: it lies.
"""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Flags, Floats, Positions
from footfall.detection.contacts import MINIMUM_DURATION, detect_contacts
from footfall.detection.filters import moving_minimum
from footfall.detection.foot_contacts import foot_contacts
from footfall.detection.intervals import Interval, covers, runs, united, without_short_ones
from footfall.detection.phases import interval_supports
from footfall.detection.tracks import FootTracks, foot_tracks, smooth_tracks
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import SupportSequence

__all__ = ["detect_limb_supports", "hands_on_the_ground", "limb_contacts"]

_REST = 0.17
"""A wrist, elbow or knee rests at most this high over the floor, in leg lengths: a palm is flat
with the wrist at 0.05, and a wrist is at 0.15 above bent fingers ..."""

_LOW = 0.05
"""... and it is low within this of where it rests, in leg lengths."""

_SLOW = (1.0, 0.5)
"""A wrist that is low carries below the first speed, an elbow or knee below the second [m/s]: all
creep more than soles, and a wrist goes round over a palm that stays."""

_REST_WINDOW = 1.2
"""Over which a point rests at its lowest place [s]."""

_LYING = 0.24
"""The pelvis or the chest is on the floor below this height over it, in leg lengths."""

_LONGEST_FALL = 0.1
"""A body may be in the air for so long on its way to lying down [s]: it drops, it does not fly."""

Limbs = tuple[tuple[Interval, ...], ...]


def detect_limb_supports(
    clip: Clip, anatomy: Anatomy | None = None, *, min_duration: float = MINIMUM_DURATION
) -> SupportSequence:
    """Find the support phases of a clip that also stands on its hands: crawls, cartwheels, get-ups.

    Feet come first, then hands after a ``+``, such as ``D+lr`` on all fours. Knees count as
    feet, forearms as hands. ``+ps`` is a body that lies: what is between feet and hands carries
    it (`footfall.support.LIMBS`).

    Args:
        clip: The motion, at least two frames.
        anatomy: Its skeleton's; found where not given.
        min_duration: No phase is shorter [s], >= 0; see `contact_supports`.

    Raises:
        ArgumentError: If the skeleton has no arm, a limit is out of its range, or the clip has a
            single frame.
    """
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    limbs = limb_contacts(clip, anatomy, min_duration=min_duration)
    return interval_supports(
        limbs, clip.duration, cyclic=clip.cyclic, min_duration=max(min_duration, 0.0)
    )


def hands_on_the_ground(clip: Clip, anatomy: Anatomy) -> tuple[float, float]:
    """Return the share of a clip in which the left and the right hand carry, 0 to 1 each.

    Zero for an arm that was not found, and for a clip of a single frame.
    """
    if any(arm is None for arm in anatomy.arms) or clip.frames < 2:
        return 0.0, 0.0
    limbs = limb_contacts(clip, anatomy)
    left, right = (sum(one.duration for one in hand) / clip.duration for hand in limbs[2:4])
    return min(left, 1.0), min(right, 1.0)


def limb_contacts(clip: Clip, anatomy: Anatomy, *, min_duration: float = MINIMUM_DURATION) -> Limbs:
    """Return when the feet, the hands and both sides of the trunk carry, in the order of `LIMBS`.

    Args:
        clip: The motion.
        anatomy: Its skeleton's.
        min_duration: Contacts and gaps shorter than this are ignored [s], >= 0.

    Raises:
        ArgumentError: If the skeleton has no arm, or the limit is out of its range.
    """
    left, right = anatomy.arms
    if left is None or right is None:
        raise ArgumentError(
            "the skeleton has no two arms that are known by their names, so that no hand can be "
            "found on the ground; detect its feet alone"
        )
    feet = detect_contacts(clip, anatomy, min_duration=min_duration).intervals
    tracks = foot_tracks(clip, anatomy)
    chest = left.shoulder if anatomy.chest is None else anatomy.chest
    joints = [anatomy.left.knee, anatomy.right.knee, left.wrist, right.wrist]
    joints += [left.elbow, right.elbow, 0, chest]
    heights, velocities = _over_the_floor(clip, joints, tracks)
    found: list[tuple[Interval, ...]] = []
    for side in range(2):
        for columns in ([side], [2 + side, 4 + side]):
            carried = _carried(heights[:, columns], velocities[:, columns], tracks)
            if columns == [side]:
                carried = united([*feet[side], *carried])
            found.append(
                without_short_ones(carried, min_duration, clip.duration, cyclic=clip.cyclic)
            )
    limbs = (found[0], found[2], found[1], found[3])
    trunk = _trunk(heights[:, 6:].min(axis=1), limbs, tracks)
    return (*limbs, trunk, trunk)


def _over_the_floor(clip: Clip, joints: list[int], tracks: FootTracks) -> tuple[Floats, Positions]:
    """Return heights [m] and velocities [m/s] of some joints, shape (samples, joints, ...)."""
    _, positions = clip.world_poses()
    smooth, velocities, _ = smooth_tracks(positions[:, joints], clip)
    drift = np.array([tracks.belt_velocity[0], 0.0, tracks.belt_velocity[1]])
    heights = smooth[..., 1]
    places = np.concatenate([heights, tracks.positions[..., 1].reshape(len(heights), -1)], axis=1)
    return heights - float(np.percentile(places, 5.0, axis=0).min()), velocities - drift


def _carried(heights: Floats, velocities: Positions, tracks: FootTracks) -> list[Interval]:
    """Return when any of some points of one limb is where it rests, and slow."""
    rest, low = _REST * tracks.leg_length, _LOW * tracks.leg_length
    radius = min(round(0.5 * _REST_WINDOW * tracks.rate), len(heights) - 1)
    lowest = moving_minimum(heights, radius, cyclic=tracks.cyclic)
    over = heights - np.minimum(lowest, rest)
    count = heights.shape[1]
    limits = np.full(count, low), np.array(_SLOW[-count:])
    return foot_contacts(over, velocities, limits, tracks)


def _trunk(heights: Floats, limbs: Limbs, tracks: FootTracks) -> tuple[Interval, ...]:
    """Return when the trunk carries because no limb does."""
    lies = heights < _LYING * tracks.leg_length
    times = np.arange(len(heights)) / tracks.rate
    alone = ~_any_limb(limbs, times, tracks)
    found: list[Interval] = []
    for first, end in runs(alone):
        resting = np.flatnonzero(lies[first:end])
        if not resting.size:
            continue
        # What rests at both ends of a stretch on the trunk does not fly in the middle of it:
        # shoulders or hips, which no joint stands for, roll over the floor.
        begin, stop = first + int(resting[0]), first + int(resting[-1]) + 1
        slack = math.ceil(_LONGEST_FALL * tracks.rate)
        begin = first if begin - first <= slack else begin
        stop = end if end - stop <= slack else stop
        # A stretch up to the neighboring contacts, so that no sliver of flight is left.
        early = -1.0 / tracks.rate if begin == first else 0.0
        late = 1.0 / tracks.rate if stop == end else 0.0
        start = max(begin / tracks.rate + early, 0.0)
        found.append(Interval(start, min(stop / tracks.rate + late, tracks.duration)))
    return tuple(found)


def _any_limb(limbs: Limbs, times: Floats, tracks: FootTracks) -> Flags:
    return np.any(
        [covers(one, times, tracks.duration, cyclic=tracks.cyclic) for one in limbs], axis=0
    )
