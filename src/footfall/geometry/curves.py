"""Hermite segments: a curve between two knots, with the slope given at both.

The cubic is the one of every textbook, and runs backward where an end slope is more than about
three times the mean slope. The rational quadratic [Gregory & Delbourgo, Piecewise rational
quadratic interpolation to monotonic data, IMA J. Numer. Anal. 2, 1982] never does. Where one end
slope is the mirror image of the other about the mean slope, both are the same parabola.

Before its first and after its last knot a segment goes on straight, with the slope it has there;
a segment of no length is a step.
"""

from __future__ import annotations

from footfall.compilation import kernel, small_kernel

__all__ = ["cubic_hermite", "rational_hermite"]


@kernel
def cubic_hermite(
    t: float, t0: float, h0: float, v0: float, t1: float, h1: float, v1: float
) -> tuple[float, float]:
    """Return value and slope at `t` of the cubic with these end values and end slopes.

    Monotone only if both end slopes stay within 0 and 3 (h1 - h0) / (t1 - t0) [Fritsch &
    Carlson 1980], but for a small region beyond.
    """
    if t >= t1:
        return (h1 + v1 * (t - t1), v1)
    if t <= t0:
        return (h0 + v0 * (t - t0), v0)
    length = t1 - t0
    mean = (h1 - h0) / length
    s = (t - t0) / length
    bend = 3.0 * mean - 2.0 * v0 - v1
    twist = v0 + v1 - 2.0 * mean
    value = h0 + length * s * (v0 + s * (bend + s * twist))
    return (value, v0 + s * (2.0 * bend + 3.0 * s * twist))


@small_kernel
def rational_hermite(
    t: float, t0: float, h0: float, v0: float, t1: float, h1: float, v1: float
) -> tuple[float, float]:
    """Return value and slope at `t` of the rational quadratic with these ends.

    Never decreasing for all h1 >= h0, v0 >= 0 and v1 >= 0, and its slope is continuous. The one
    exception no such curve escapes: where h1 = h0 it is constant between the knots, with
    slope zero there, whatever the end slopes.
    """
    if t >= t1:
        return (h1 + v1 * (t - t1), v1)
    if t <= t0:
        return (h0 + v0 * (t - t0), v0)
    length = t1 - t0
    rise = h1 - h0
    mean = rise / length
    if mean <= 0.0:
        return (h0, 0.0)
    s = (t - t0) / length
    past = s * s
    middle = s * (1.0 - s)
    ahead = (1.0 - s) * (1.0 - s)
    # At least mean / 2, since `middle` is at most 1 / 4.
    divisor = mean + (v0 + v1 - 2.0 * mean) * middle
    value = h0 + rise * ((mean * past + v0 * middle) / divisor)
    steepness = mean / divisor
    slope = steepness * steepness * (v1 * past + 2.0 * mean * middle + v0 * ahead)
    return (value, slope)
