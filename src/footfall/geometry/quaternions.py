"""Quaternions (wxyz), component by component: one source for scalars in kernels and for arrays.

Each function takes and returns components. `product` and `rotate` use only arithmetic and
therefore mean the same on four numbers inside a kernel and on four arrays outside (`rotations`
wraps them for arrays); `normalize` and `between` do without branches and, like those, also serve
eight characters at once (`footfall.octets`).
"""

from __future__ import annotations

import math

from footfall.compilation import kernel, small_kernel
from footfall.octets import select, square_root

__all__ = [
    "between",
    "conjugate_rotate",
    "from_yaw",
    "nlerp",
    "normalize",
    "product",
    "quotient",
    "rotate",
    "yaw_of",
]


@small_kernel
def product(
    aw: float, ax: float, ay: float, az: float, bw: float, bx: float, by: float, bz: float
) -> tuple[float, float, float, float]:
    """Return a b: first b, then a."""
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


@small_kernel
def quotient(
    aw: float, ax: float, ay: float, az: float, bw: float, bx: float, by: float, bz: float
) -> tuple[float, float, float, float]:
    """Return a⁻¹ b: b as seen from a."""
    return (
        aw * bw + ax * bx + ay * by + az * bz,
        aw * bx - ax * bw - ay * bz + az * by,
        aw * by + ax * bz - ay * bw - az * bx,
        aw * bz - ax * by + ay * bx - az * bw,
    )


@small_kernel
def rotate(
    qw: float, qx: float, qy: float, qz: float, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return the vector (x, y, z) rotated by q."""
    tx = 2.0 * (qy * z - qz * y)
    ty = 2.0 * (qz * x - qx * z)
    tz = 2.0 * (qx * y - qy * x)
    return (
        x + qw * tx + qy * tz - qz * ty,
        y + qw * ty + qz * tx - qx * tz,
        z + qw * tz + qx * ty - qy * tx,
    )


@small_kernel
def conjugate_rotate(
    qw: float, qx: float, qy: float, qz: float, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return the vector (x, y, z) rotated by q⁻¹."""
    return rotate(qw, -qx, -qy, -qz, x, y, z)


@small_kernel
def normalize(qw: float, qx: float, qy: float, qz: float) -> tuple[float, float, float, float]:
    """Return q scaled to unit length; the identity where q is zero."""
    length = square_root(qw * qw + qx * qx + qy * qy + qz * qz)
    empty = length <= 0.0
    scale = 1.0 / select(empty, 1.0, length)
    return (select(empty, 1.0, qw * scale), qx * scale, qy * scale, qz * scale)


@kernel
def nlerp(
    aw: float,
    ax: float,
    ay: float,
    az: float,
    bw: float,
    bx: float,
    by: float,
    bz: float,
    fraction: float,
) -> tuple[float, float, float, float]:
    """Return the normalized mix of a (fraction 0) and b (fraction 1), the short way round."""
    other = fraction if aw * bw + ax * bx + ay * by + az * bz >= 0.0 else -fraction
    one = 1.0 - fraction
    return normalize(
        one * aw + other * bw, one * ax + other * bx, one * ay + other * by, one * az + other * bz
    )


@small_kernel
def between(
    ax: float, ay: float, az: float, bx: float, by: float, bz: float
) -> tuple[float, float, float, float]:
    """Return the shortest rotation that turns direction a into direction b.

    The identity where either vector is zero; half a turn about some axis across a where they
    are opposed.
    """
    scale = square_root((ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz))
    w = scale + ax * bx + ay * by + az * bz
    opposed = w < 1e-14 * scale
    steep = ax * ax < ay * ay
    x = select(opposed, select(steep, 0.0, az), ay * bz - az * by)
    y = select(opposed, select(steep, -az, 0.0), az * bx - ax * bz)
    z = select(opposed, select(steep, ay, -ax), ax * by - ay * bx)
    return normalize(select(opposed, 0.0, w), x, y, z)


@small_kernel
def from_yaw(yaw: float) -> tuple[float, float, float, float]:
    """Return the rotation by an angle [rad] about the vertical, +y; positive turns z to x."""
    return (math.cos(0.5 * yaw), 0.0, math.sin(0.5 * yaw), 0.0)


@small_kernel
def yaw_of(qw: float, qy: float) -> float:
    """Return the angle [rad] of the twist about the vertical of a rotation with these w and y."""
    return 2.0 * math.atan2(qy, qw)
