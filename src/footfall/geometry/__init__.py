"""Mathematics that has never heard of a character."""

from footfall.geometry.curves import cubic_hermite, rational_hermite
from footfall.geometry.rotations import (
    blend_rotations,
    conjugate,
    continuous,
    from_axis_angle,
    from_euler,
    from_matrix,
    from_rotation_vector,
    from_yaw,
    multiply,
    rotate,
    slerp,
    to_euler,
    to_rotation_vector,
)

__all__ = [
    "blend_rotations",
    "conjugate",
    "continuous",
    "cubic_hermite",
    "from_axis_angle",
    "from_euler",
    "from_matrix",
    "from_rotation_vector",
    "from_yaw",
    "multiply",
    "rational_hermite",
    "rotate",
    "slerp",
    "to_euler",
    "to_rotation_vector",
]
