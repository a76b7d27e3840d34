"""A steady frame rate for motions that are stored as keys at any times."""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Floats, Seconds
from footfall.errors import ArgumentError
from footfall.io.conclusions import Conclusion
from footfall.io.frame_rate import USUAL_RATES

__all__ = ["conclude_key_rate", "frame_times"]

DENSE = 18.0
"""Keys closer than this [per second] are one a frame; others are posed by hand."""

SMOOTH = 60.0
"""Frames per second of motions whose keys fit no usual rate."""

ROUNDING = 0.01
"""How far from a frame a key may lie [frames]: times are stored in single precision."""


def conclude_key_rate(keys: Seconds, fps: float | None) -> Conclusion[float]:
    """Return the rate at which keys are to be sampled.

    Args:
        keys: When there is a key, of any joint, rising, at least one, shape (keys,) [s].
        fps: What the caller wants, if anything.

    Raises:
        ArgumentError: If `fps` is not positive.
    """
    if fps is not None:
        if not (math.isfinite(fps) and fps > 0.0):
            raise ArgumentError(f"fps={fps} is impossible; it must be > 0")
        return Conclusion(float(fps), f"{fps:g} frames per second, as asked for")
    if len(keys) < 2:
        return Conclusion(30.0, "30 frames per second: with a single key any rate will do")
    duration = float(keys[-1] - keys[0])
    spacing = float(np.diff(keys).min())
    count = round(duration / spacing)
    rate = count / duration
    if DENSE <= rate <= 1000.0 and _fits(keys, rate):
        usual = min(USUAL_RATES, key=lambda one: abs(one - rate))
        # The last key times the rate is a whole number: the usual rate must keep it so.
        if abs(usual - rate) * duration < ROUNDING:
            rate = float(usual)
        return Conclusion(rate, f"{rate:.9g} frames per second: there is a key a frame")
    for usual in USUAL_RATES:
        if usual >= (20 if 1.0 / spacing > DENSE else 30) and _fits(keys, usual):
            return Conclusion(
                float(usual), f"{usual} frames per second: the least usual rate with all keys on it"
            )
    rate = max(1.0, math.ceil(duration * SMOOTH)) / duration
    return Conclusion(
        rate,
        f"{rate:.9g} frames per second: the keys lie on no usual rate, and this one keeps the "
        "first and the last of them",
    )


def _fits(keys: Seconds, rate: float) -> bool:
    """Whether every key lies on a frame."""
    frames: Floats = (keys - keys[0]) * rate
    rounding = ROUNDING + 4e-7 * keys[-1] * rate
    return bool((np.abs(frames - np.round(frames)) <= rounding).all())


def frame_times(keys: Seconds, rate: float, greatest: int) -> Seconds | None:
    """Return the times of the frames from the first to the last key.

    Args:
        keys: As in `conclude_key_rate`.
        rate: Frames per second.
        greatest: How many frames are allowed.

    Returns:
        Shape (frames,); None where they would be more.
    """
    count = math.floor((keys[-1] - keys[0]) * rate + ROUNDING) + 1
    if count > greatest:
        return None
    frames: Floats = np.arange(count, dtype=np.float64)
    return float(keys[0]) + frames / rate
