"""Which joint of a file is the pelvis, and what becomes of the joints above it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from footfall.arrays import Positions
from footfall.geometry import multiply, rotate
from footfall.io.bvh_rig import BvhRig
from footfall.io.conclusions import Conclusion
from footfall.skeleton import Anatomy, Skeleton

__all__ = ["depth_first", "fold_root", "rest_skeleton", "translation_of"]


def translation_of(rig: BvhRig, joint: int) -> Positions:
    """Return where a joint sits in its parent's frame, in the file's unit, shape (frames, 3)."""
    if joint in rig.translations:
        return rig.translations[joint]
    return np.broadcast_to(rig.offsets[joint], (rig.frames, 3))


def rest_skeleton(rig: BvhRig) -> Skeleton:
    """Return the body of a rig in its own unit; where a joint moves, its median place."""
    offsets = rig.offsets.copy()
    for joint, places in rig.translations.items():
        offsets[joint] = np.median(places, axis=0)
    offsets[0] = 0.0
    return Skeleton(rig.names, rig.parents, offsets, rig.tips)


def depth_first(rig: BvhRig) -> BvhRig:
    """Return the rig with every joint's descendants right behind it, as skeletons have them."""
    order: list[int] = []
    waiting = [0]
    while waiting:
        joint = waiting.pop()
        order.append(joint)
        waiting += np.flatnonzero(rig.parents == joint)[::-1].tolist()
    if order == list(range(len(order))):
        return rig
    place = {joint: index for index, joint in enumerate(order)}
    return replace(
        rig,
        names=tuple(rig.names[joint] for joint in order),
        parents=np.array([place.get(int(rig.parents[joint]), -1) for joint in order]),
        offsets=rig.offsets[order],
        tips=rig.tips[order],
        rotations=rig.rotations[:, order],
        translations={place[joint]: places for joint, places in rig.translations.items()},
    )


def fold_root(rig: BvhRig, anatomy: Anatomy | None) -> tuple[BvhRig, Conclusion[str]]:
    """Fold joints that only carry the pelvis into its motion through the world.

    The pelvis is where the legs part. A node above it that has nothing else to carry (a static
    one, one that runs along on the ground, a second pelvis) is no part of the body.

    Args:
        rig: What the file holds.
        anatomy: Its legs; None where there are none, and then nothing is folded.

    Returns:
        The rig whose joint 0 is the pelvis, and why.
    """
    if anatomy is None:
        name = rig.names[0]
        return rig, Conclusion(name, f"{name!r}, the file's root; without legs it is left as it is")
    pelvis = _parting(rig, anatomy.left.hip, anatomy.right.hip)
    top = 0
    while top != pelvis and np.count_nonzero(rig.parents == top) == 1:
        top = int(np.flatnonzero(rig.parents == top)[0])
    name = rig.names[top]
    if top == 0:
        return rig, Conclusion(name, f"{name!r}, the file's root")
    folded = _without_ancestors(rig, top)
    chain = ", ".join(repr(dropped) for dropped in rig.names[:top])
    verb = "carries" if top == 1 else "carry"
    return folded, Conclusion(
        name,
        f"{name!r}: {chain} above it {verb} nothing else, and became part of its motion through "
        "the world",
    )


def _parting(rig: BvhRig, left: int, right: int) -> int:
    """Return the deepest joint above both hips."""
    above: set[int] = set()
    joint = left
    while joint >= 0:
        above.add(joint)
        joint = int(rig.parents[joint])
    joint = right
    while joint not in above:
        joint = int(rig.parents[joint])
    return joint


def _without_ancestors(rig: BvhRig, top: int) -> BvhRig:
    """Return the rig that begins at `top`; all joints before it are its ancestors."""
    rotations = rig.rotations[:, 0]
    places = translation_of(rig, 0)
    for joint in range(1, top + 1):
        places = places + rotate(rotations, translation_of(rig, joint))
        rotations = multiply(rotations, rig.rotations[:, joint])
    kept = rig.rotations[:, top:].copy()
    kept[:, 0] = rotations
    translations = {j - top: t for j, t in rig.translations.items() if j > top}
    translations[0] = places
    parents = rig.parents[top:] - top
    parents[0] = -1
    return replace(
        rig,
        names=rig.names[top:],
        parents=parents,
        offsets=rig.offsets[top:],
        tips=rig.tips[top:],
        rotations=kept,
        translations=translations,
    )
