"""From a clip to what the library keeps of it: normalized poses, their root, resting feet."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Flags, Floats, Positions, Rotations, SmallFloats
from footfall.geometry import conjugate, multiply
from footfall.motion import Clip, extract_root_path
from footfall.skeleton import Anatomy
from footfall.skeleton.normalized import ANKLES, EFFECTORS, channel_count, normalize
from footfall.skeleton.rig import Rig, rig_of
from footfall.support import SupportSequence

__all__ = ["PackedClip", "carrying_feet", "pack_clip", "pack_standing", "rest_alike"]

RESTING_SHARE = 15.0
"""Percentile of a foot point's heights, while the foot carries, that is its height at rest:
low, since the heel is up for much of a stance, but above the noise."""


class PackedClip(NamedTuple):
    """One clip, ready to be appended to the library."""

    keys: SmallFloats
    """Normalized poses, shape (frames, channels)."""

    roots: Floats
    """x and z in leg lengths, heading [rad], shape (frames, 3)."""

    resting_heights: Floats
    """Heel and toe of each foot over the ground at rest, in leg lengths, shape (2, 2)."""

    floor: float
    """Height of the ground in the clip's own world [m]."""

    leg_length: float
    """Of the clip's own body [m]."""


def pack_clip(clip: Clip, anatomy: Anatomy, supports: SupportSequence) -> PackedClip:
    """Normalize a clip.

    The ground is where the lowest point of each foot rests while the foot carries, on average.

    Args:
        clip: The motion.
        anatomy: What the joints of its skeleton are, heels on the soles.
        supports: What carries the body when.
    """
    rotations, positions = clip.world_poses()
    rig = rig_of(clip.skeleton, anatomy)
    carried = carrying_feet(clip, supports)
    resting = _resting_heights(rig, rotations, positions, carried)
    floor = float(resting.min(axis=1).mean())
    path = extract_root_path(clip, anatomy)
    keys = normalize(
        clip.skeleton, rig, clip.pelvis_positions, clip.local_rotations, path.headings, floor
    )
    roots = np.column_stack([path.positions / rig.leg_length, path.headings])
    return PackedClip(
        keys,
        roots,
        (resting - floor) / rig.leg_length,
        floor,
        rig.leg_length,
    )


def rest_alike(packed: PackedClip, resting: Floats) -> PackedClip:
    """Return a clip whose feet rest as high as those of others, each raised as a whole.

    Captured floors are not quite level: a foot rests some millimeters higher in one clip than in
    another, and higher than the other foot. It would hover where the clips are mixed.

    Args:
        packed: The clip.
        resting: How high heel and toe of each foot rest in the others, shape (2, 2).
    """
    rise = (resting - packed.resting_heights).mean(axis=1)
    if not rise.any():
        return packed
    keys = packed.keys.copy()
    for side in range(2):
        keys[:, keys.shape[1] - EFFECTORS + ANKLES + 3 * side + 1] += rise[side]
    return packed._replace(keys=keys, resting_heights=packed.resting_heights + rise[:, np.newaxis])


def carrying_feet(clip: Clip, supports: SupportSequence) -> Flags:
    """Return whether each foot carries in each frame, shape (frames, 2)."""
    phases = [supports.support_at(frame / clip.fps) for frame in range(clip.frames)]
    return np.array([(support.left, support.right) for support in phases])


def _resting_heights(
    rig: Rig, rotations: Rotations, positions: Positions, carried: Flags
) -> Floats:
    """Return how high heel and toe of each foot are while it carries [m], shape (2, 2)."""
    resting = np.empty((2, 2))
    for side in range(2):
        frames = carried[:, side] if carried[:, side].any() else np.ones(len(carried), dtype=bool)
        ankle = rig.limbs[side, 2]
        for point in range(2):
            offset = np.concatenate([[0.0], rig.foot_points[side, point]])
            turned = multiply(rotations[frames, ankle], offset)
            turned = multiply(turned, conjugate(rotations[frames, ankle]))
            heights = positions[frames, ankle, 1] + turned[:, 2]
            resting[side, point] = np.percentile(heights, RESTING_SHARE)
    return resting


def pack_standing(packed: PackedClip, joints: int) -> SmallFloats:
    """Return a neutral pose made from a clip: its mean posture, both feet on the ground.

    Args:
        packed: Any clip; that of a gait gives the most natural stance.
        joints: How many joints its body has.

    Returns:
        One normalized pose, shape (1, channels).
    """
    keys = packed.keys.astype(np.float64)
    pose = np.empty((1, channel_count(joints)), dtype=np.float32)
    rotations = keys[:, : 4 * joints + 8].reshape(len(keys), -1, 4)
    mean = rotations.mean(axis=0)
    mean /= np.maximum(np.linalg.norm(mean, axis=-1, keepdims=True), 1e-12)
    effectors = keys[:, 4 * joints + 8 :].mean(axis=0)
    for side in range(2):
        # A foot is flat on the ground where its ankle is lowest.
        height = 4 * joints + 8 + ANKLES + 3 * side + 1
        flattest = int(np.argmin(keys[:, height]))
        mean[joints + side] = rotations[flattest, joints + side]
        effectors[ANKLES + 3 * side + 1] = keys[flattest, height]
    pose[0, : 4 * joints + 8] = mean.reshape(-1)
    effectors[3] = effectors[6] = 0.5 * (effectors[3] + effectors[6])
    pose[0, 4 * joints + 8 :] = effectors
    return pose
