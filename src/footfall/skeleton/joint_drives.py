"""Which joints of a reference body drive the joints of another: part by part."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats
from footfall.skeleton.anatomy import Arm
from footfall.skeleton.body_map import Drive
from footfall.skeleton.joint_names import read_joint_name
from footfall.skeleton.landmarks import Landmarks
from footfall.skeleton.leg_search import SIDES, descendants
from footfall.skeleton.skeleton import Skeleton

__all__ = ["all_drives", "landmark_drives", "same_drives"]

_SHORTEST = 1e-9


def same_drives(reference: Skeleton, body: Skeleton) -> dict[int, Drive]:
    """Return the drives of a body of the same family: every joint by its namesake."""
    order = reference.order_of(body).tolist()
    return {
        joint: Drive(other, other, 0.0, "the same joint of the same skeleton family")
        for joint, other in enumerate(order)
    }


def landmark_drives(
    reference: Skeleton, body: Skeleton, marks: Landmarks, own: Landmarks
) -> dict[int, Drive]:
    """Return the drives of a body's landmarks and fingers.

    Args:
        reference: The body that leads.
        body: The body that follows.
        marks: Landmarks of the reference.
        own: Landmarks of the body.
    """
    drives = _column_drives(reference, body, marks, own)
    for side in range(2):
        drives |= _leg_drives(marks, own, side)
        drives |= _arm_drives(reference, body, marks, own, side)
    return drives


def all_drives(body: Skeleton, found: dict[int, Drive], pelvis: int) -> list[Drive]:
    """Return a drive for every joint: what is no landmark moves with what is above it.

    Args:
        body: The body that follows.
        found: The drives of its landmarks.
        pelvis: The pelvis of the reference.
    """
    drives: list[Drive] = []
    for joint in range(body.count):
        parent = int(body.parents[joint])
        if joint in found:
            drives.append(found[joint])
        elif parent < 0:
            drives.append(Drive(pelvis, pelvis, 0.0, "above the pelvis, moves with it"))
        else:
            above = drives[parent]
            reason = f"no landmark, moves with {body.names[parent]!r}"
            drives.append(Drive(above.one, above.other, above.fraction, reason))
    return drives


def _column_drives(
    reference: Skeleton, body: Skeleton, marks: Landmarks, own: Landmarks
) -> dict[int, Drive]:
    drives: dict[int, Drive] = {}
    lower = _arc_shares(body, own)
    upper = _arc_shares(reference, marks)
    trunk = [(upper[joint], joint) for joint in marks.trunk]
    for joint in own.trunk:
        drives[joint] = _between(trunk, lower[joint], "trunk")
    neck = [(upper[joint], joint) for joint in (marks.chest, *marks.neck)]
    if marks.head is not None and marks.head in upper:
        neck.append((upper[marks.head], marks.head))
    for joint in own.neck:
        drives[joint] = _between(neck, lower[joint], "neck")
    if own.head is not None:
        source = marks.chest if marks.head is None else marks.head
        drives[own.head] = Drive(source, source, 0.0, "head")
    return drives


def _arc_shares(skeleton: Skeleton, marks: Landmarks) -> dict[int, float]:
    """Return where the bones of the column are: 0 at the pelvis, 1 at the chest, 2 at the head.

    A joint turns the bone above it, so that it counts at the middle of that bone.
    """
    joints = [*marks.trunk, *marks.neck]
    if marks.head is not None and marks.head not in joints:
        joints.append(marks.head)
    steps = [_rise(skeleton, upper, lower) for upper, lower in pairwise(joints)]
    starts = np.concatenate([[0.0], np.cumsum(steps)])
    middles = 0.5 * (starts + np.append(starts[1:], starts[-1]))
    chest = len(marks.trunk) - 1
    shares = np.concatenate([_shares(middles[: chest + 1]), 1.0 + _shares(middles[chest:])[1:]])
    return dict(zip(joints, shares.tolist(), strict=True))


def _shares(places: Floats) -> Floats:
    """Return places from 0 to 1, evenly where they are all the same."""
    span = float(places[-1] - places[0])
    if span > _SHORTEST:
        return (places - places[0]) / span
    return np.linspace(0.0, 1.0, len(places)) if len(places) > 1 else np.zeros(1)


def _rise(skeleton: Skeleton, upper: int, lower: int) -> float:
    """Return the length of the bones from a joint down to one below it [m], 0 on other branches."""
    length, joint = 0.0, lower
    while joint not in (upper, -1):
        length += skeleton.bone_length(joint)
        joint = int(skeleton.parents[joint])
    return length


def _between(places: Sequence[tuple[float, int]], share: float, part: str) -> Drive:
    """Return the drive of a joint at a share of the way along the reference's column."""
    for (low, one), (high, other) in pairwise(places):
        if share <= high:
            span = high - low
            fraction = 0.0 if span < _SHORTEST else min(max((share - low) / span, 0.0), 1.0)
            if fraction < _SHORTEST:
                return Drive(one, one, 0.0, part)
            if fraction > 1.0 - _SHORTEST:
                return Drive(other, other, 0.0, part)
            return Drive(one, other, fraction, part)
    last = places[-1][1]
    return Drive(last, last, 0.0, part)


def _leg_drives(marks: Landmarks, own: Landmarks, side: int) -> dict[int, Drive]:
    leg, source = own.anatomy.legs[side], marks.anatomy.legs[side]
    drives = {
        leg.hip: _alone(source.hip, f"{SIDES[side]} thigh"),
        leg.knee: _alone(source.knee, f"{SIDES[side]} shank"),
        leg.ankle: _alone(source.ankle, f"{SIDES[side]} foot"),
    }
    toe, source_toe = own.toes[side], marks.toes[side]
    if toe is not None and source_toe is not None:
        drives[toe] = _alone(source_toe, f"{SIDES[side]} toes")
    return drives


def _arm_drives(
    reference: Skeleton, body: Skeleton, marks: Landmarks, own: Landmarks, side: int
) -> dict[int, Drive]:
    arm, source = own.anatomy.arms[side], marks.anatomy.arms[side]
    if arm is None or source is None:
        return {}
    drives = {
        arm.shoulder: _alone(source.shoulder, f"{SIDES[side]} upper arm"),
        arm.elbow: _alone(source.elbow, f"{SIDES[side]} forearm"),
        arm.wrist: _alone(source.wrist, f"{SIDES[side]} hand"),
    }
    clavicle = own.clavicles[side]
    if clavicle is not None:
        found = marks.clavicles[side]
        how = "by its clavicle" if found is not None else "by the chest, there is no clavicle"
        drives[clavicle] = _alone(
            marks.chest if found is None else found, f"{SIDES[side]} clavicle, {how}"
        )
    return drives | _finger_drives(reference, body, source, arm)


def _finger_drives(reference: Skeleton, body: Skeleton, source: Arm, arm: Arm) -> dict[int, Drive]:
    """Return the drives of what hangs on a hand and has the same name on both bodies."""
    theirs = {_key(reference, joint): joint for joint in descendants(reference, source.wrist)}
    drives: dict[int, Drive] = {}
    for joint in descendants(body, arm.wrist):
        other = theirs.get(_key(body, joint))
        if other is not None:
            drives[joint] = _alone(other, "finger, by its name")
    return drives


def _key(skeleton: Skeleton, joint: int) -> tuple[tuple[str, ...], str]:
    """Return what two fingers of one name share: words without rig and side, and numbers."""
    name = skeleton.names[joint]
    words = tuple(word for word in read_joint_name(name).words if word not in ("character", "bip"))
    return words, "".join(filter(str.isdigit, name.rsplit("_", 1)[-1]))


def _alone(joint: int, part: str) -> Drive:
    return Drive(joint, joint, 0.0, part)
