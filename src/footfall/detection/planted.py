"""When feet are planted: the still part of each contact, for footprints."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats
from footfall.detection.contacts import track_contacts
from footfall.detection.intervals import Interval
from footfall.detection.tracks import FootTracks, foot_tracks
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy

__all__ = ["planted_intervals"]

_STILL = 0.12
"""A foot is still below this speed of its slower point [m/s] ..."""

_USUAL = 1.5
"""... or below this multiple of its median in the contact, where the foot never is that still."""


def planted_intervals(
    clip: Clip, anatomy: Anatomy | None = None
) -> tuple[tuple[Interval, ...], tuple[Interval, ...]]:
    """Return when each foot is planted: its contacts without their moving edges.

    Support phases want loose limits, or double support vanishes; footprints want tight ones, or
    their edges slide. Each interval lies within one contact, and each contact has one.

    Args:
        clip: The motion.
        anatomy: Its skeleton's; found where not given.

    Returns:
        Intervals of the left and of the right foot, in order; on a cycle they start in
        [0, duration) or, where the contact does, a little later.
    """
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    tracks = foot_tracks(clip, anatomy)
    contacts = track_contacts(tracks, np.arange(clip.frames) / clip.fps)
    speeds = np.linalg.norm(tracks.velocities[..., [0, 2]], axis=-1).min(axis=-1)
    left, right = (
        tuple(_still_part(interval, speeds[:, foot], tracks) for interval in intervals)
        for foot, intervals in enumerate(contacts.intervals)
    )
    return left, right


def _still_part(contact: Interval, speeds: Floats, tracks: FootTracks) -> Interval:
    """Return the contact from its first to its last still sample."""
    first = int(np.ceil(contact.start * tracks.rate))
    rows = np.arange(first, max(int(np.floor(contact.end * tracks.rate)), first) + 1)
    if tracks.cyclic:
        part = speeds[rows % len(speeds)]
    else:
        part = speeds[np.minimum(rows, len(speeds) - 1)]
    still = np.flatnonzero(part <= max(_STILL, _USUAL * float(np.median(part))))
    start = max(contact.start, float(rows[still[0]] / tracks.rate))
    end = min(contact.end, float(rows[still[-1]] / tracks.rate))
    if start >= end:
        return contact
    return Interval(start, end, contact.start_confidence, contact.end_confidence)
