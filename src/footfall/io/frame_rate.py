"""Frames per second, from a Frame Time that was rounded when it was written."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext
from functools import lru_cache

from footfall.errors import ArgumentError
from footfall.io.conclusions import Conclusion

__all__ = ["conclude_rate", "frame_time_text"]

USUAL_RATES = (10, 12, 15, 16, 20, 24, 25, 30, 40, 48, 50, 60, 72, 75, 80, 90, 100, 120, 125, 144)
"""Whole rates that cameras and tools are set to, up to 144; above, multiples of ten."""

BROADCAST_RATES = tuple(Decimal(rate) for rate in ("23.976", "29.97", "59.94", "119.88"))
"""Rates of television, looked for where no whole one fits."""

PLAUSIBLE = (5.0, 1000.0)
"""Outside this range [frames per second] a Frame Time is said to be implausible."""


def conclude_rate(frame_time: Decimal, fps: float | None) -> Conclusion[float]:
    """Return the frame rate that a Frame Time means.

    A Frame Time of 0.033333 is 1/30 written with six decimals: where exactly one usual rate gives
    the digits of the file, it is that rate.

    Args:
        frame_time: What the file says, digit by digit [s].
        fps: What the caller says instead, if anything.

    Raises:
        ArgumentError: If `fps` is not positive.
    """
    if fps is not None:
        if not (math.isfinite(fps) and fps > 0.0):
            raise ArgumentError(f"fps={fps} is impossible; it must be > 0")
        return Conclusion(
            float(fps), f"{fps:g} frames per second, as asked for; the file says {frame_time} s"
        )
    with localcontext() as context:
        context.prec = 60
        exact = Decimal(1) / frame_time
        meant = _meant_rates(str(frame_time))
    rate = float(exact)
    reason = f"{rate:.9g} frames per second: the file's frame time is {frame_time.normalize()} s"
    if not rate.is_integer() and len(meant) == 1 and float(meant[0]) != rate:
        rate = float(meant[0])
        reason = (
            f"{rate:g} frames per second: the file's frame time of {frame_time.normalize()} s is "
            f"1/{rate:g} s rounded"
        )
    if not PLAUSIBLE[0] <= rate <= PLAUSIBLE[1]:
        reason += (
            "; THIS IS IMPLAUSIBLE and the true rate cannot be known from the file: "
            "pass fps= if you know it"
        )
    return Conclusion(rate, reason)


@lru_cache(maxsize=256)
def _meant_rates(digits: str) -> tuple[Decimal, ...]:
    """Return the usual rates that give the digits of the file.

    By their text, since 0.0333 and 0.03330 are one number and not the same rounding.
    """
    frame_time = Decimal(digits)
    whole = (*USUAL_RATES, *range(150, 1001, 10))
    for rates in ([Decimal(rate) for rate in whole], BROADCAST_RATES):
        meant = tuple(rate for rate in rates if _rounds_to(rate, frame_time))
        if meant:
            return meant
    return ()


def _rounds_to(rate: Decimal, frame_time: Decimal) -> bool:
    """Whether 1/rate, written with as many decimals as the file has, reads as the file does."""
    exponent = frame_time.as_tuple().exponent
    if not isinstance(exponent, int) or not -30 <= exponent < 0:
        return False
    if len(frame_time.normalize().as_tuple().digits) < 2:
        # One digit is no rounding to go by: 0.03 is as far from 1/30 as 33 is from 30.
        return False
    return (1 / rate).quantize(Decimal(1).scaleb(exponent)) == frame_time


def frame_time_text(fps: float) -> str:
    """Return the seconds of a frame with so many digits that the rate is read back exactly."""
    with localcontext() as context:
        context.prec = 30
        return f"{1 / Decimal(fps):f}"
