"""Whether a foot is on the ground by one fixed threshold: the rules of published tools.

Each takes the two points of a foot, ankle and toe, as those tools do, and says that the foot is
down where either point is. Speeds are backward differences from frame to frame, unfiltered.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from footfall.arrays import Flags, Floats, Positions
from footfall.geometry import rotate
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy

__all__ = [
    "FIXED_RULES",
    "displacement_contacts",
    "height_and_speed_contacts",
    "speed_contacts",
]


def speed_contacts(clip: Clip, anatomy: Anatomy | None = None, *, speed: float = 0.15) -> Flags:
    """Return whether each foot is slow, as motion-matching tools label contacts.

    Args:
        clip: The motion.
        anatomy: What its joints are.
        speed: Below which a point is down [m/s].

    Returns:
        Flags, shape (frames, 2 feet).
    """
    return _either(_speeds(clip, _points(clip, anatomy)) < speed)


def height_and_speed_contacts(
    clip: Clip, anatomy: Anatomy | None = None, *, speed: float = 0.10, height: float = 0.08
) -> Flags:
    """Return whether each foot is slow and low, as retargeting and capture tools do.

    Args:
        clip: The motion.
        anatomy: What its joints are.
        speed: Below which a point may be down [m/s].
        height: Below which, over the lowest point of the clip [m].

    Returns:
        Flags, shape (frames, 2 feet).
    """
    points = _points(clip, anatomy)
    heights = points[..., 1] - points[..., 1].min()
    return _either((_speeds(clip, points) < speed) & (heights < height))


def displacement_contacts(
    clip: Clip, anatomy: Anatomy | None = None, *, squared: float = 0.002
) -> Flags:
    """Return whether each foot moves little per frame, as learned motion models' data is made.

    Args:
        clip: The motion.
        anatomy: What its joints are.
        squared: Squared displacement from frame to frame below which a point is down [m²]. The
            limit is another speed at every frame rate: 0.89 m/s at 20 frames a second, where it
            comes from, 1.34 at 30, 5.4 at 120.

    Returns:
        Flags, shape (frames, 2 feet).
    """
    points = _points(clip, anatomy)
    return _either(_steps(points) ** 2 < squared)


FIXED_RULES: Mapping[str, Callable[[Clip], Flags]] = MappingProxyType(
    {
        "speed < 0.15 m/s": speed_contacts,
        "speed < 0.10 m/s and height < 0.08 m": height_and_speed_contacts,
        "squared step < 0.002 m²": displacement_contacts,
    }
)
"""The rules by what they say."""


def _points(clip: Clip, anatomy: Anatomy | None) -> Positions:
    """Return ankle and toe of each foot [m], shape (frames, 2 feet, 2 points, 3)."""
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    rotations, positions = clip.world_poses()
    points = np.empty((clip.frames, 2, 2, 3))
    for side, leg in enumerate(anatomy.legs):
        turned = rotate(rotations[:, leg.toe.joint], np.array(leg.toe.offset))
        points[:, side, 0] = positions[:, leg.ankle]
        points[:, side, 1] = positions[:, leg.toe.joint] + turned
    return points


def _steps(points: Positions) -> Floats:
    """Return the way of each point from the frame before [m]; the first frame as the second."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=-1)
    return np.concatenate([steps[:1], steps])


def _speeds(clip: Clip, points: Positions) -> Floats:
    return _steps(points) * clip.fps


def _either(down: Flags) -> Flags:
    """Return whether ankle or toe is down, shape (frames, 2 feet)."""
    return down[..., 0] | down[..., 1]
