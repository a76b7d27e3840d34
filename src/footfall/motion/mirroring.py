"""Mirror a clip: what the left did, the right does, on the same body."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, Rotations
from footfall.geometry import conjugate, continuous, from_matrix, multiply
from footfall.motion.clip import Clip
from footfall.motion.leg_placement import place_feet
from footfall.motion.mirror_frames import frame_reflections, mirrored_joints
from footfall.motion.pelvis_drop import pelvis_drops
from footfall.skeleton import Anatomy, world_poses

__all__ = ["mirror"]

_MIRROR = np.array([-1.0, 1.0, 1.0])


def mirror(clip: Clip, anatomy: Anatomy) -> Clip:
    """Return a clip mirrored across the plane x = 0, on the same skeleton.

    Every bone points where its partner's mirror image points, however the files orient the
    joints' frames. Then the legs are solved so that the ankles are at the mirror images of their
    partners', also where the two legs are not quite of one length; where the shorter one cannot
    reach, the pelvis is lowered. On a body with equal sides the result is the exact mirror image,
    and mirroring twice gives the clip back. Else the ankles still are, toes and trunk miss it by
    about the difference between the sides (on captured bodies 0 to 15 mm), and knees that were
    straight bend for it, by up to 80 mm.

    Args:
        clip: The motion.
        anatomy: Which joints its legs are.
    """
    skeleton = clip.skeleton
    partners = mirrored_joints(skeleton, anatomy)
    reflections = frame_reflections(skeleton, clip.local_rotations, partners)
    _, positions = clip.world_poses()
    local = _mirrored_rotations(clip, partners, reflections)
    pelvis = clip.pelvis_positions * _MIRROR
    ankles = positions[:, [leg.ankle for leg in reversed(anatomy.legs)]] * _MIRROR
    drops = pelvis_drops(skeleton, anatomy, pelvis, local, ankles, clip.fps, clip.cyclic)
    feet = world_poses(skeleton, pelvis, local)[0][:, [leg.ankle for leg in anatomy.legs]]
    pelvis[:, 1] -= drops
    local = place_feet(skeleton, anatomy, pelvis, local, ankles, feet)
    lowered = f", the pelvis lowered by up to {1000 * drops.max():.1f} mm" if drops.any() else ""
    return clip.evolve(
        pelvis_positions=pelvis,
        local_rotations=local / np.linalg.norm(local, axis=-1, keepdims=True),
        because=f"mirrored: {int((partners != np.arange(len(partners))).sum()) // 2} pairs of "
        f"joints were exchanged{lowered}",
    )


def _mirrored_rotations(clip: Clip, partners: Indices, reflections: Floats) -> Rotations:
    """Return the local rotations of the mirror image, shape (frames, joints, 4).

    R' = M R_partner C, where M and C are half turns about x and about an axis, each with every
    axis turned over: the signs cancel, and quaternions can do it.
    """
    rotations, _ = clip.world_poses()
    half_turn = np.array([0.0, 1.0, 0.0, 0.0])
    frames = from_matrix(-reflections)
    world = multiply(multiply(half_turn, rotations[:, partners]), frames)
    local = world.copy()
    parents = clip.skeleton.parents
    local[:, 1:] = multiply(conjugate(world[:, parents[1:]]), world[:, 1:])
    return continuous(local)
