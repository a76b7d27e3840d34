"""The joints of the SMPL family of body models: their names, their tree, and where they stand.

Where the joints of a person stand is in the model's own file, which its makers license to users
and not to us. Without it a labelled approximate body stands in, of our own numbers: lengths of
segments as shares of stature (Winter 2009, "Biomechanics and motor control of human movement",
figure 4.1, after Drillis & Contini 1966), in a T-pose, y up, facing +z, the left side at +x.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from footfall.arrays import Positions

__all__ = ["SMPL_PARENTS", "SMPL_TREES", "STATURE", "approximate_joints"]

STATURE = 1.70
"""Of the approximate body [m]."""

_BODY = {
    "pelvis": "",
    "left_hip": "pelvis",
    "right_hip": "pelvis",
    "spine1": "pelvis",
    "left_knee": "left_hip",
    "right_knee": "right_hip",
    "spine2": "spine1",
    "left_ankle": "left_knee",
    "right_ankle": "right_knee",
    "spine3": "spine2",
    "left_foot": "left_ankle",
    "right_foot": "right_ankle",
    "neck": "spine3",
    "left_collar": "spine3",
    "right_collar": "spine3",
    "head": "neck",
    "left_shoulder": "left_collar",
    "right_shoulder": "right_collar",
    "left_elbow": "left_shoulder",
    "right_elbow": "right_shoulder",
    "left_wrist": "left_elbow",
    "right_wrist": "right_elbow",
}
_FINGERS = ("index", "middle", "pinky", "ring", "thumb")


def _fingers(side: str) -> dict[str, str]:
    return {
        f"{side}_{finger}{bone}": f"{side}_wrist" if bone == 1 else f"{side}_{finger}{bone - 1}"
        for finger in _FINGERS
        for bone in (1, 2, 3)
    }


_HANDS = _fingers("left") | _fingers("right")
_FACE = {"jaw": "head", "left_eye": "head", "right_eye": "head"}

SMPL_TREES: Mapping[str, Mapping[str, str]] = {
    "SMPL body": _BODY,
    "SMPL": _BODY | {"left_hand": "left_wrist", "right_hand": "right_wrist"},
    "SMPL-H": _BODY | _HANDS,
    "SMPL-X": _BODY | _FACE | _HANDS,
}
"""Each model's joints in the order of its poses, and the parent of each."""

SMPL_PARENTS = {
    model: np.array([-1, *(list(tree).index(parent) for parent in list(tree.values())[1:])])
    for model, tree in SMPL_TREES.items()
}
"""The same by index, shape (joints,)."""

_SHARES = {
    "pelvis": (0.0, 0.570, 0.0),
    "hip": (0.050, 0.530, 0.0),
    "knee": (0.050, 0.285, 0.0),
    "ankle": (0.050, 0.039, 0.0),
    "foot": (0.055, 0.012, 0.100),
    "spine1": (0.0, 0.630, 0.0),
    "spine2": (0.0, 0.705, 0.0),
    "spine3": (0.0, 0.740, 0.0),
    "neck": (0.0, 0.850, 0.0),
    "head": (0.0, 0.900, 0.015),
    "collar": (0.045, 0.800, 0.0),
    "shoulder": (0.115, 0.818, 0.0),
    "elbow": (0.301, 0.818, 0.0),
    "wrist": (0.447, 0.818, 0.0),
    "hand": (0.497, 0.818, 0.0),
    "jaw": (0.0, 0.895, 0.025),
    "eye": (0.018, 0.936, 0.055),
}
"""Outward, height and forward of the joints, as shares of stature."""

_KNUCKLES = {
    "index": (0.055, 0.013),
    "middle": (0.057, 0.0),
    "pinky": (0.048, -0.023),
    "ring": (0.054, -0.012),
    "thumb": (0.015, 0.018),
}
"""Outward from the wrist, and forward, of the first joint of each finger."""


def approximate_joints(model: str) -> Positions:
    """Return where the joints of the approximate body stand, the pelvis at the origin [m].

    Args:
        model: A key of `SMPL_TREES`.

    Returns:
        Shape (joints, 3).
    """
    places = np.array([_share(name) for name in SMPL_TREES[model]])
    return STATURE * (places - places[0])


def _share(name: str) -> tuple[float, float, float]:
    side, _, part = name.partition("_")
    if side not in ("left", "right"):
        return _SHARES[name]
    sign = 1.0 if side == "left" else -1.0
    if part in _SHARES:
        outward, height, forward = _SHARES[part]
        return sign * outward, height, forward
    wrist, height, _ = _SHARES["wrist"]
    out, forward = _KNUCKLES[part[:-1]]
    return sign * (wrist + out + 0.017 * (int(part[-1]) - 1)), height, forward
