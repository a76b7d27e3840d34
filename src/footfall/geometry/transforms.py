"""Planar frames: a place on the ground and a heading, (x, z, heading), component by component.

A frame is written ``a_from_b``: it takes points seen from b to points seen from a. As in
`quaternions`, the same source works on numbers inside a kernel and on arrays outside.
"""

from __future__ import annotations

import numpy as np

from footfall.compilation import small_kernel

__all__ = ["apply", "compose", "inverse", "relative", "turn"]


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
