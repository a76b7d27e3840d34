"""The body that performs the samples: an adult of 1.75 m.

Its segment lengths are the shares of body height of Drillis and Contini, as printed in Winter,
*Biomechanics and Motor Control of Human Movement*, figure 4.1: thigh 0.245, shank 0.246, ankle
0.039 above the ground, foot length 0.152. At rest it stands in a T-pose on flat feet.
"""

from __future__ import annotations

import numpy as np

from footfall.skeleton import Skeleton

__all__ = [
    "ANKLE_HEIGHT",
    "BALL_HEIGHT",
    "HEEL_FROM_ANKLE",
    "HIP_DROP",
    "HIP_HALF_WIDTH",
    "SHANK",
    "THIGH",
    "TOE_FROM_ANKLE",
    "sample_skeleton",
]

THIGH = 0.429
"""Hip to knee [m]."""

SHANK = 0.430
"""Knee to ankle [m]."""

ANKLE_HEIGHT = 0.07
"""Ankle over the ground, standing on a flat foot [m]."""

BALL_HEIGHT = 0.02
"""Toe joint (ball of the foot) over the ground, standing on a flat foot [m]."""

TOE_FROM_ANKLE = (0.0, BALL_HEIGHT - ANKLE_HEIGHT, 0.13)
"""The toe joint in the ankle's frame [m]."""

HEEL_FROM_ANKLE = (0.0, -ANKLE_HEIGHT, -0.045)
"""The hind end of the sole in the ankle's frame [m]."""

HIP_HALF_WIDTH = 0.088
"""A hip's distance from the middle of the body [m]."""

HIP_DROP = 0.045
"""A hip's depth below the pelvis joint [m]."""

_TRUNK = (
    ("Hips", None, (0.0, 0.0, 0.0)),
    ("Spine", "Hips", (0.0, 0.09, -0.01)),
    ("Spine1", "Spine", (0.0, 0.12, -0.005)),
    ("Spine2", "Spine1", (0.0, 0.13, 0.0)),
    ("Neck", "Spine2", (0.0, 0.165, 0.0)),
    ("Head", "Neck", (0.0, 0.09, 0.02)),
)

_ARM = (
    ("Shoulder", "Spine2", (0.02, 0.12, 0.01)),
    ("Arm", "Shoulder", (0.165, 0.0, -0.01)),
    ("ForeArm", "Arm", (0.30, 0.0, 0.0)),
    ("Hand", "ForeArm", (0.255, 0.0, 0.0)),
)

_LEG = (
    ("UpLeg", "Hips", (HIP_HALF_WIDTH, -HIP_DROP, 0.0)),
    ("Leg", "UpLeg", (0.0, -THIGH, 0.0)),
    ("Foot", "Leg", (0.0, -SHANK, 0.0)),
    ("ToeBase", "Foot", TOE_FROM_ANKLE),
)

_TIPS = {
    "Head": (0.0, 0.18, 0.0),
    "Hand": (0.17, 0.0, 0.0),
    "ToeBase": (0.0, -0.008, 0.075),
}


def sample_skeleton() -> Skeleton:
    """Return the body of all samples: 22 joints, facing +z, identity rotations at rest."""
    joints = list(_TRUNK)
    tips = {"Head": _TIPS["Head"]}
    for limb in (_ARM, _LEG):
        own = {name for name, _, _ in limb}
        for side, sign in (("Left", 1.0), ("Right", -1.0)):
            for name, parent, (x, y, z) in limb:
                above = f"{side}{parent}" if parent in own else parent
                joints.append((f"{side}{name}", above, (sign * x, y, z)))
            x, y, z = _TIPS[limb[-1][0]]
            tips[f"{side}{limb[-1][0]}"] = (sign * x, y, z)
    names = tuple(name for name, _, _ in joints)
    return Skeleton(
        names,
        np.array([-1 if above is None else names.index(above) for _, above, _ in joints]),
        np.array([offset for _, _, offset in joints]),
        np.array([tips.get(name, (0.0, 0.0, 0.0)) for name in names]),
    )
