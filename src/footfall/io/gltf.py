"""Motions out as GLB: a skeleton, one animation, and a mannequin that shows it in any viewer."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from footfall.geometry import continuous
from footfall.io.atomic import write_atomically
from footfall.io.clip_mannequin import COLORS, clip_mannequin
from footfall.io.gltf_animation import animation_record
from footfall.io.gltf_buffers import ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, BufferBuilder, glb_bytes
from footfall.io.mannequin import Mannequin, Tone
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.skeleton.landmarks import rest_positions

__all__ = ["save_gltf"]


def save_gltf(clip: Clip, path: Path, *, supports: str | None = None) -> None:
    """Write a self-contained .glb file.

    The keys are linear, one a frame; quaternions change sign nowhere, so that no viewer turns
    a joint the long way round.

    Args:
        clip: The motion.
        path: The file; replaced if it exists.
        supports: What carries the body, one of ``R L D -`` a frame; kept with the animation,
            in its `extras`.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    buffers = BufferBuilder()
    skeleton = clip.skeleton
    surface = clip_mannequin(clip)
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": "footfall"},
        "scene": 0,
        "scenes": [{"name": clip.name, "nodes": [0, skeleton.count]}],
        "nodes": [
            *_joint_nodes(clip),
            {"name": _unused_name(skeleton, "mannequin"), "mesh": 0, "skin": 0},
        ],
        "materials": [_material(tone) for tone in _tones(surface)],
        "meshes": [{"name": "mannequin", "primitives": _primitives(surface, skeleton, buffers)}],
        "skins": [_skin(skeleton, buffers)],
        "animations": [_animation(clip, supports, buffers)],
    }
    document["bufferViews"] = buffers.views
    document["accessors"] = buffers.accessors
    document["buffers"] = [{"byteLength": len(buffers.data)}]
    write_atomically(path, glb_bytes(document, buffers.data))


def _joint_nodes(clip: Clip) -> list[dict[str, Any]]:
    """Return a node a joint, posed as in the first frame for viewers that play nothing."""
    skeleton = clip.skeleton
    nodes: list[dict[str, Any]] = []
    for joint, name in enumerate(skeleton.names):
        place = clip.pelvis_positions[0] if joint == 0 else skeleton.rest_offsets[joint]
        node: dict[str, Any] = {
            "name": name,
            "translation": np.float32(place).tolist(),
            "rotation": np.float32(np.roll(clip.local_rotations[0, joint], -1)).tolist(),
        }
        if children := skeleton.children(joint):
            node["children"] = list(children)
        nodes.append(node)
    return nodes


def _unused_name(skeleton: Skeleton, name: str) -> str:
    while name in skeleton.names:
        name += "_"
    return name


def _tones(surface: Mannequin) -> list[Tone]:
    return [Tone(tone) for tone in np.unique(surface.tones).tolist()]


def _material(tone: Tone) -> dict[str, Any]:
    return {
        "name": tone.name.lower(),
        "pbrMetallicRoughness": {
            "baseColorFactor": [*COLORS[tone], 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": 0.75,
        },
    }


def _primitives(
    surface: Mannequin, skeleton: Skeleton, buffers: BufferBuilder
) -> list[dict[str, Any]]:
    """Return a primitive a material, each vertex bound to two joints at most."""
    places = surface.positions + rest_positions(skeleton)[surface.joints]
    primitives: list[dict[str, Any]] = []
    for material, tone in enumerate(_tones(surface)):
        used, triangles = np.unique(surface.triangles[surface.tones == tone], return_inverse=True)
        joints = np.zeros((len(used), 4), dtype=np.int64)
        weights = np.zeros((len(used), 4), dtype=np.int64)
        weights[:, 1] = np.rint(255.0 * surface.shares[used])
        weights[:, 0] = 255 - weights[:, 1]
        joints[:, 0] = surface.joints[used]
        # A joint without a weight has to be joint 0 [glTF 2.0, 3.7.3.1].
        joints[:, 1] = np.where(weights[:, 1] > 0, surface.others[used], 0)
        attributes = {
            "POSITION": buffers.add(places[used], "f4", target=ARRAY_BUFFER, bounds=True),
            "NORMAL": buffers.add(surface.normals[used], "f4", target=ARRAY_BUFFER),
            "JOINTS_0": buffers.add(
                joints, "u1" if skeleton.count <= 256 else "u2", target=ARRAY_BUFFER
            ),
            "WEIGHTS_0": buffers.add(weights, "u1", target=ARRAY_BUFFER, normalized=True),
        }
        indices = buffers.add(
            triangles.reshape(-1), "u2" if len(used) < 65535 else "u4", target=ELEMENT_ARRAY_BUFFER
        )
        primitives.append({"attributes": attributes, "indices": indices, "material": material})
    return primitives


def _skin(skeleton: Skeleton, buffers: BufferBuilder) -> dict[str, Any]:
    """Return the skin: its mesh stands in the rest pose, where no joint is turned."""
    inverse = np.tile(np.eye(4), (skeleton.count, 1, 1))
    # glTF stores matrices column by column.
    inverse[:, 3, :3] = -rest_positions(skeleton)
    return {
        "inverseBindMatrices": buffers.add(inverse, "f4"),
        "skeleton": 0,
        "joints": list(range(skeleton.count)),
    }


def _animation(clip: Clip, supports: str | None, buffers: BufferBuilder) -> dict[str, Any]:
    rotations = continuous(clip.local_rotations)
    tracks = [(0, "translation", clip.pelvis_positions)]
    tracks += [(joint, "rotation", rotations[:, joint]) for joint in range(clip.skeleton.count)]
    return animation_record(clip, supports, tracks, buffers)
