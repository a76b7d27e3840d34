"""The joints of a glTF file frame by frame, as the readers of all files see them."""

from __future__ import annotations

from decimal import Decimal

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, Seconds
from footfall.errors import FileFormatError
from footfall.geometry import conjugate, multiply, rotate
from footfall.io.bvh_rig import BvhRig
from footfall.io.gltf_document import GltfDocument
from footfall.io.gltf_joints import GltfJoints
from footfall.io.gltf_keys import Channel
from footfall.io.gltf_nodes import GltfNodes

__all__ = ["rig_at"]

STILL = 2e-6
"""A joint that moves by less in its parent does not move [m]: rounding of single precision."""

UNEVEN = 1e-3
"""A node may stretch one axis by this share more than another: rounding in exporters."""


def rig_at(
    document: GltfDocument,
    nodes: GltfNodes,
    joints: GltfJoints,
    channels: list[Channel],
    times: Seconds,
    rate: float,
) -> BvhRig:
    """Return the joints at these times; scales become longer and shorter bones.

    Args:
        document: The file, for messages.
        nodes: Its nodes.
        joints: Those that are joints.
        channels: The animation.
        times: When, shape (frames,) [s].
        rate: Frames per second.

    Raises:
        FileFormatError: If a joint stretches what is below it unevenly, or mirrors it.
    """
    frames, count, rest = len(times), len(joints.nodes), joints.rest_rotations
    by_target = {(channel.node, channel.path): channel for channel in channels}
    rotations = np.empty((frames, count, 4))
    translations: dict[int, Positions] = {}
    offsets = np.zeros((count, 3))
    # The even stretch above each joint and its own, axis by axis, shapes (frames or 1, 1 or 3).
    stretches: list[tuple[Floats, Floats]] = []
    for joint, node in enumerate(joints.nodes):
        places, turns, scale = _placed(by_target, nodes, node, times)
        parent, back = joints.parents[joint], conjugate(rest[joint])
        if parent < 0:
            rotations[:, joint] = multiply(turns, back)
            stretches.append((np.ones((1, 1)), scale))
        else:
            above, own = stretches[parent]
            places = rotate(rest[parent], places * above * own)
            rotations[:, joint] = multiply(multiply(rest[parent], turns), back)
            stretches.append((above * own.mean(axis=1, keepdims=True), scale))
        _check_stretch(document, joints, joint, scale)
        offsets[joint] = places[0]
        if parent < 0 or np.ptp(places, axis=0).max() > STILL:
            translations[joint] = np.array(np.broadcast_to(places, (frames, 3)))
    return BvhRig(
        joints.names,
        np.array(joints.parents, dtype=np.int64),
        offsets,
        np.zeros((count, 3)),
        _unit(rotations),
        translations,
        frames,
        Decimal(1) / Decimal(rate),
    )


def _placed(
    by_target: dict[tuple[int, str], Channel], nodes: GltfNodes, node: int, times: Seconds
) -> tuple[Positions, Rotations, Floats]:
    """Return translations, rotations and scales of a node, shapes (frames or 1, 3 or 4)."""
    still = {
        "translation": nodes.translations[node],
        "rotation": nodes.rotations[node],
        "scale": nodes.scales[node],
    }
    places, turns, scale = (
        by_target[node, path].at(times) if (node, path) in by_target else value[np.newaxis]
        for path, value in still.items()
    )
    return places, turns, scale


def _check_stretch(document: GltfDocument, joints: GltfJoints, joint: int, scale: Floats) -> None:
    """Refuse a scale that no bones of any length can say.

    Bones that end in the node may be stretched unevenly: it moves their ends only. What hangs
    further below would be sheared as it turns.
    """
    children = [j for j, parent in enumerate(joints.parents) if parent == joint]
    below = any(parent in children for parent in joints.parents)
    if children and scale.min() < 0.0:
        raise FileFormatError(
            f"node {joints.names[joint]!r} has a scale of {float(scale.min()):.3g}, which mirrors "
            "the joints below it; apply the scale before the export",
            path=document.path,
        )
    uneven = float(np.ptp(scale, axis=1).max()) if below else 0.0
    if uneven > UNEVEN * max(float(np.abs(scale).max()), 1e-12):
        raise FileFormatError(
            f"node {joints.names[joint]!r} is stretched unevenly, by {scale[0, 0]:.4g}, "
            f"{scale[0, 1]:.4g} and {scale[0, 2]:.4g}, which shears the joints below it; "
            "apply the scale before the export",
            path=document.path,
        )


def _unit(rotations: Rotations) -> Rotations:
    return rotations / np.linalg.norm(rotations, axis=-1, keepdims=True)
