"""Planar frames: a place on the ground and a heading, (x, z, heading), component by component.

A frame is written ``a_from_b``: it takes points seen from b to points seen from a. As in
`quaternions`, the same source works on numbers inside a kernel and on arrays outside.
"""

from __future__ import annotations

import math

import numpy as np

from footfall.compilation import small_kernel

__all__ = ["apply", "compose", "cosine_and_sine", "inverse", "relative", "turn"]

SMALL = 0.125 * 0.125
"""Square of an angle of which a few terms give cosine and sine to the last bit [rad²]."""


@small_kernel
def apply(
    frame_x: float, frame_z: float, heading: float, x: float, z: float
) -> tuple[float, float]:
    """Return a point (x, z) [m] of a frame as seen from where the frame stands.

    Args:
        frame_x: Where the frame is [m].
        frame_z: Where the frame is [m].
        heading: Its yaw [rad], positive from z towards x.
        x: The point in the frame [m].
        z: The point in the frame [m].
    """
    cosine, sine = np.cos(heading), np.sin(heading)
    return (frame_x + cosine * x + sine * z, frame_z - sine * x + cosine * z)


@small_kernel
def cosine_and_sine(angle: float) -> tuple[float, float]:
    """Return both of an angle [rad], a number; fast where it is small, as what one frame turns."""
    square = angle * angle
    if square > SMALL:
        return math.cos(angle), math.sin(angle)
    # Taylor's series; what is left out is below the last bit.
    cosine = 1.0 / 40320.0 - square * (1.0 / 3628800.0)
    cosine = 1.0 / 24.0 - square * (1.0 / 720.0 - square * cosine)
    sine = 1.0 / 120.0 - square * (1.0 / 5040.0 - square * (1.0 / 362880.0))
    return 1.0 - square * (0.5 - square * cosine), angle * (
        1.0 - square * (1.0 / 6.0 - square * sine)
    )


@small_kernel
def turn(cosine: float, sine: float, x: float, z: float) -> tuple[float, float]:
    """Return a direction (x, z) of a frame with this heading as seen from outside."""
    return (cosine * x + sine * z, cosine * z - sine * x)


@small_kernel
def compose(
    ax: float, az: float, a_heading: float, bx: float, bz: float, b_heading: float
) -> tuple[float, float, float]:
    """Return a b, the frame b given as seen from a, as seen from where a stands."""
    x, z = apply(ax, az, a_heading, bx, bz)
    return (x, z, a_heading + b_heading)


@small_kernel
def inverse(x: float, z: float, heading: float) -> tuple[float, float, float]:
    """Return a⁻¹: where the outside stands as seen from the frame."""
    cosine, sine = np.cos(heading), np.sin(heading)
    return (sine * z - cosine * x, -sine * x - cosine * z, -heading)


@small_kernel
def relative(
    ax: float, az: float, a_heading: float, bx: float, bz: float, b_heading: float
) -> tuple[float, float, float]:
    """Return a⁻¹ b: the frame b as seen from the frame a."""
    x, z = apply(0.0, 0.0, -a_heading, bx - ax, bz - az)
    return (x, z, b_heading - a_heading)
