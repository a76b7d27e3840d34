"""Play a motion on another body: its turns by the map, its lengths by its legs, its soles as stood.

Joints turn as the map says. The root's path and the hips' height are scaled by the length of the
legs, wrists by that of the arms, and then the legs are solved so that the soles stand where the
leader's soles stand.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from footfall.arrays import Flags, Floats, Positions, Rotations
from footfall.errors import SkeletonError
from footfall.geometry import continuous, rotate
from footfall.motion.arm_clearance import clear_arm
from footfall.motion.arm_placement import place_wrist
from footfall.motion.clip import Clip
from footfall.motion.leg_placement import place_feet
from footfall.motion.limb_attitudes import observe_attitudes
from footfall.motion.pelvis_drop import pelvis_drops
from footfall.motion.sampling import cycle_displacement
from footfall.motion.sole_placement import ankles_on_soles, soles_of
from footfall.motion.sole_planting import FootPaths, cyclic_offsets, planted_offsets
from footfall.motion.soles import with_soles
from footfall.skeleton import Anatomy, Skeleton, find_anatomy, world_poses
from footfall.skeleton.body_map import BodyMap, body_rotations, local_rotations
from footfall.skeleton.canonical_pose import LimbAttitudes
from footfall.skeleton.capsule_overlap import forearm_overlap
from footfall.skeleton.correspondence import Correction, map_body
from footfall.skeleton.rig import rig_of

__all__ = ["map_clip", "performer_anatomy", "retarget"]


def map_clip(
    clip: Clip,
    body: Skeleton,
    body_clip: Clip | None = None,
    corrections: Mapping[str, Correction | None] | None = None,
) -> BodyMap:
    """Return the map from a clip's body to another one.

    Args:
        clip: A motion of the body that leads; it shows its hinges and soles.
        body: The body that follows.
        body_clip: A motion of that body, which shows its; None: it is known at rest only.
        corrections: Joints that are driven otherwise than is found; see `map_body`.

    Raises:
        SkeletonError: If there is no map; see `map_body`.
    """
    seen = None if clip.skeleton.same_family(body) else _seen(clip)
    own = None if body_clip is None or seen is None else _seen(body_clip)
    return map_body(
        clip.skeleton,
        body,
        reference_attitudes=seen,
        body_attitudes=own,
        corrections=corrections,
    )


def _seen(clip: Clip) -> LimbAttitudes:
    return observe_attitudes(clip, find_anatomy(clip.skeleton))


def retarget(
    clip: Clip,
    body: Skeleton,
    body_map: BodyMap | None = None,
    carries: Flags | None = None,
) -> Clip:
    """Return a motion as another body performs it.

    Args:
        clip: The motion.
        body: The body that is to perform it.
        body_map: What drives its joints; by default what `map_clip` finds.
        carries: Whether left and right foot carry the body, shape (frames, 2): there its soles
            are kept still and on the ground. None: they do as the leader's do.

    Raises:
        SkeletonError: If there is no map between the two bodies, or it is another bodies' map.
    """
    found = map_clip(clip, body) if body_map is None else body_map
    if found.reference.names != clip.skeleton.names or found.body.names != body.names:
        raise SkeletonError("the map is of other bodies than those of the motion and its performer")
    rotations, positions = clip.world_poses()
    leader = with_soles(find_anatomy(clip.skeleton), rotations, positions)
    soles = soles_of(clip.skeleton, leader, rotations, positions)
    world = body_rotations(found, rotations)
    local = local_rotations(body, world)
    own = find_anatomy(body)
    pelvis = _pelvis(clip, found, world)
    standing = with_soles(own, world, world_poses(body, pelvis, local)[1])
    offsets = rig_of(body, standing).foot_points
    feet = world[:, [leg.ankle for leg in own.legs]]
    ankles = ankles_on_soles(soles, found.leg_ratio, offsets, feet)
    if carries is not None:
        points = ankles[:, :, np.newaxis] + rotate(feet[:, :, np.newaxis], offsets)
        ankles += _planted(clip, found.leg_ratio, soles.points, points, carries)
    local = _with_hands(clip, found, own, positions, pelvis, local)
    drops = pelvis_drops(body, own, pelvis, local, ankles, clip.fps, clip.cyclic)
    pelvis[:, 1] -= drops
    local = place_feet(body, own, pelvis, local, ankles, feet)
    return _told(clip, body, found, pelvis, local, drops)


def performer_anatomy(clip: Clip, body_map: BodyMap) -> Anatomy:
    """Return what the joints of a performer are, its heels where retargeting takes them to be.

    They are on its soles where the leader's are: how a foot stands is read from the leader, since
    a motion of a few steps, or one that mostly sits, does not show it well.

    Args:
        clip: The motion that is retargeted.
        body_map: What drives the performer's joints.
    """
    world = body_rotations(body_map, clip.world_poses()[0])
    pelvis, local = _pelvis(clip, body_map, world), local_rotations(body_map.body, world)
    _, positions = world_poses(body_map.body, pelvis, local)
    return with_soles(find_anatomy(body_map.body), world, positions)


def _pelvis(clip: Clip, found: BodyMap, world: Rotations) -> Positions:
    """Return joint 0 such that the hips are where the leader's are, scaled [m], (frames, 3)."""
    hips = clip.pelvis_positions + rotate(clip.local_rotations[:, 0], found.reference_hips)
    pelvis = found.leg_ratio * hips - rotate(world[:, 0], found.body_hips)
    pelvis[:, 1] += found.ankle_lift
    return pelvis


def _planted(
    clip: Clip,
    ratio: float,
    leading: Positions,
    own: Positions,
    carries: Flags,
) -> Positions:
    """Return how far to move the feet so that they stay where they are planted [m]."""
    offsets: list[Positions] = []
    for foot in range(2):
        paths = FootPaths(ratio * leading[:, foot], own[:, foot], carries[:, foot])
        if clip.cyclic:
            shift, yaw = cycle_displacement(clip)
            offsets.append(cyclic_offsets(paths, clip.fps, yaw, ratio * shift))
        else:
            offsets.append(planted_offsets(paths, clip.fps))
    return np.stack(offsets, axis=1)


def _with_hands(
    clip: Clip,
    found: BodyMap,
    own: Anatomy,
    positions: Positions,
    pelvis: Positions,
    local: Rotations,
) -> Rotations:
    """Return rotations with the wrists as far from the shoulders as the leader's, scaled.

    And with the arms no deeper in the trunk than the leader's, whose `positions` these are.
    """
    leader = find_anatomy(clip.skeleton)
    for side, source in enumerate(leader.arms):
        arm = own.arms[side]
        if arm is None or source is None:
            continue
        _, places = world_poses(found.body, pelvis, local)
        reach = positions[:, source.wrist] - positions[:, source.shoulder]
        wrists = places[:, arm.shoulder] + found.arm_ratios[side] * reach
        if np.abs(wrists - places[:, arm.wrist]).max() > 1e-6:
            local = place_wrist(found.body, arm, pelvis, local, wrists)
        theirs = forearm_overlap(clip.skeleton, leader, positions, side)
        if theirs is not None:
            pose = pelvis, local
            allowed = np.maximum(min(found.leg_ratio, 1.0) * theirs.depths, 0.0)
            local = clear_arm(found.body, own, side, pose, allowed, clip.fps, clip.cyclic)
    return local


def _told(
    clip: Clip, body: Skeleton, found: BodyMap, pelvis: Positions, local: Rotations, drops: Floats
) -> Clip:
    local = continuous(local / np.linalg.norm(local, axis=-1, keepdims=True))
    if clip.cyclic:
        local[-1, 1:] = local[0, 1:]
    lowered = f", the pelvis lowered by up to {1000 * drops.max():.0f} mm" if drops.any() else ""
    return clip.evolve(
        skeleton=body,
        pelvis_positions=pelvis,
        local_rotations=local,
        because=f"retargeted from {clip.skeleton.count} to {body.count} joints, legs "
        f"{found.leg_ratio:.3f} times as long{lowered}",
    )
