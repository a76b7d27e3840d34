"""Skate metrics of other people's papers, so that results can be set beside theirs.

They guess contacts from heights over the floor, and so judge only what looks planted. The floor
is where the toes rest: files of one family may differ by several centimeters.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Flags, Floats

__all__ = ["skating_ratio", "weighted_skate"]

ANKLE_HEIGHT = 0.08
"""Below this height an ankle counts [m] (OMOMO)."""

TOE_HEIGHT = 0.04
"""Below this height a toe counts [m] (OMOMO)."""

SKATING_HEIGHT = 0.05
"""Below this height a toe is in contact [m] (GMD)."""

SKATING_SPEED = 0.5
"""Above this horizontal speed it skates [m/s] (GMD)."""

SKATING_WINDOW = 5
"""How many frames its speed is averaged over (GMD)."""


def weighted_skate(
    ankles: Floats, ankle_heights: Floats, toes: Floats, toe_heights: Floats
) -> float:
    """Return the exponentially weighted skate [mm per frame] (Li et al. 2023, OMOMO).

    Per joint ``(1000 / T) Σ d (2 − 2^(h / H))`` over the frames with ``h < H``, where d is the
    horizontal displacement to the next frame [m], h the height over the floor, H 0.08 m for
    ankles and 0.04 m for toes; the mean of the four joints. It depends on the frame rate: compare
    at equal rates only.

    Args:
        ankles: x and z of the ankles on their surface [m], shape (frames, 2 feet, 2).
        ankle_heights: Their heights over it [m], shape (frames, 2 feet).
        toes: The same of the toes.
        toe_heights: The same of the toes.
    """
    per_joint = (
        _weighted(ankles, ankle_heights, ANKLE_HEIGHT),
        _weighted(toes, toe_heights, TOE_HEIGHT),
    )
    return 1000.0 * float(np.mean(per_joint))


def skating_ratio(toes: Floats, heights: Floats, fps: float) -> float | None:
    """Return the share of frames in which a foot skates, 0 to 1 (Karunratanakul et al. 2023, GMD).

    A toe is in contact if it is below 0.05 m in both of two adjacent frames; it skates if
    meanwhile its horizontal speed, and the mean of that speed over the five frames around
    (standing still before the first and after the last), both exceed 0.5 m/s. None where there
    are no two frames.

    Args:
        toes: x and z of the toes on their surface [m], shape (frames, 2 feet, 2).
        heights: Their heights over it [m], shape (frames, 2 feet).
        fps: Frames per second.
    """
    if len(toes) < 2:
        return None
    speeds = np.linalg.norm(np.diff(toes, axis=0), axis=-1) * fps
    low = heights < SKATING_HEIGHT
    fast: Flags = (speeds > SKATING_SPEED) & (_centered_means(speeds) > SKATING_SPEED)
    return float((low[1:] & low[:-1] & fast).any(axis=1).mean())


def _weighted(places: Floats, heights: Floats, limit: float) -> Floats:
    """Return the mean of d (2 − 2^(h / H)) over all frames [m], shape (2 feet,)."""
    steps = np.linalg.norm(np.diff(places, axis=0), axis=-1)
    shares = 2.0 - np.exp2(np.minimum(heights[:-1] / limit, 1.0))
    return (steps * shares).sum(axis=0) / len(places)


def _centered_means(speeds: Floats) -> Floats:
    half = SKATING_WINDOW // 2
    padded = np.pad(speeds, ((half, half), (0, 0)))
    windows = np.lib.stride_tricks.sliding_window_view(padded, SKATING_WINDOW, axis=0)
    return windows.mean(axis=-1)
