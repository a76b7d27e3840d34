"""Skinned characters out: the file that they came from, with other animations in it."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.errors import ArgumentError
from footfall.geometry import conjugate, continuous, from_matrix, multiply, rotate
from footfall.io.atomic import write_atomically
from footfall.io.gltf_animation import animation_record
from footfall.io.gltf_buffers import BufferBuilder, glb_bytes
from footfall.io.gltf_document import MESHOPT, GltfDocument, bytes_of_uri
from footfall.io.gltf_nodes import read_nodes
from footfall.io.gltf_rig import STILL
from footfall.io.gltf_skin_repair import lift_skins, normalize_weights
from footfall.io.skinned_body import SkinnedBody
from footfall.motion import Clip

__all__ = ["save_skinned"]


def save_skinned(
    body: SkinnedBody,
    clips: Sequence[Clip],
    path: Path | str,
    *,
    supports: Sequence[str | None] | None = None,
    keep: bool = False,
) -> None:
    """Write a character that performs clips, as a self-contained .glb file.

    Meshes, materials, textures and all else are as in the character's own file. Only what changes
    no picture is set right: compressed buffers are written unpacked, files beside it are taken in,
    weights sum to one, and skinned meshes hang on no node. The pelvis carries the way through the
    world.

    Args:
        body: The character.
        clips: The animations, at least one, all on the character's own skeleton.
        path: The file; replaced if it exists.
        supports: What carries the body in each clip, ``R L D -`` a frame; kept in `extras`.
        keep: Whether the file's own animations stay, behind the new ones.

    Raises:
        ClipError: If a clip is of another body; retarget it first.
        ArgumentError: If there is no clip, or not one text of supports for each.
        FileFormatError: If the file cannot be written.
    """
    if not clips:
        raise ArgumentError("there are no clips to write; give at least one")
    if supports is not None and len(supports) != len(clips):
        raise ArgumentError(
            f"{len(supports)} texts of supports for {len(clips)} clips; give one each"
        )
    for clip in clips:
        body.check(clip)
    document: dict[str, Any] = copy.deepcopy(body.document.root.content)
    buffers = _unpacked(document, body.document)
    _take_in_images(document, body.document, buffers)
    _write_poses(document, body)
    lift_skins(document)
    normalize_weights(document, body.document, buffers)
    # A file has no animations, or some: an empty list is none of glTF's.
    own = document.pop("animations", [])
    document["animations"] = [
        _animation(body, clip, None if supports is None else supports[index], buffers)
        for index, clip in enumerate(clips)
    ] + (own if keep else [])
    document["bufferViews"] = buffers.views
    document["accessors"] = buffers.accessors
    document["buffers"] = [{"byteLength": len(buffers.data)}]
    write_atomically(Path(path), glb_bytes(document, buffers.data))


def _unpacked(document: dict[str, Any], source: GltfDocument) -> BufferBuilder:
    """Return all data of a file in one buffer; what needs no decoder needs no extension."""
    buffers = BufferBuilder()
    for index, view in enumerate(document.get("bufferViews", [])):
        kept = {
            name: view[name] for name in ("byteStride", "target", "name", "extras") if name in view
        }
        buffers.add_view(source.view_bytes(index), **kept)
    buffers.accessors = document.get("accessors", [])
    for name in ("extensionsUsed", "extensionsRequired"):
        others = [one for one in document.pop(name, []) if one != MESHOPT]
        if others:
            document[name] = others
    return buffers


def _take_in_images(document: dict[str, Any], source: GltfDocument, buffers: BufferBuilder) -> None:
    """Put images that stand in files beside the character into the buffer."""
    for image, record in zip(
        document.get("images", []), source.root.records("images"), strict=True
    ):
        if "uri" not in image or image["uri"].startswith("data:"):
            continue
        data = bytes_of_uri(record)
        png = data[:8] == b"\x89PNG\r\n\x1a\n"
        image.setdefault("mimeType", "image/png" if png else "image/jpeg")
        del image["uri"]
        image["bufferView"] = buffers.add_view(data)


def _write_poses(document: dict[str, Any], body: SkinnedBody) -> None:
    """Say with translation, rotation and scale what a matrix said: only those can be moved."""
    nodes = read_nodes(body.document)
    for node in body.nodes:
        record = document["nodes"][node]
        if record.pop("matrix", None) is not None:
            record["translation"] = nodes.translations[node].tolist()
            record["rotation"] = np.roll(nodes.rotations[node], -1).tolist()
            record["scale"] = nodes.scales[node].tolist()


def _animation(
    body: SkinnedBody, clip: Clip, supports: str | None, buffers: BufferBuilder
) -> dict[str, Any]:
    places, rotations = _node_motion(body, clip)
    tracks = [(body.nodes[0], "translation", places)]
    tracks += [
        (body.nodes[joint], "translation", np.repeat(place[np.newaxis], clip.frames, axis=0))
        for joint, place in _moved_joints(body, clip)
    ]
    tracks += [(node, "rotation", rotations[:, joint]) for joint, node in enumerate(body.nodes)]
    return animation_record(clip, supports, tracks, buffers)


def _moved_joints(body: SkinnedBody, clip: Clip) -> list[tuple[int, Positions]]:
    """Return the joints that a clip has elsewhere than the file, and where their nodes stand."""
    moved: list[tuple[int, Positions]] = []
    for joint in range(1, body.skeleton.count):
        offset = clip.skeleton.rest_offsets[joint]
        if np.abs(offset - body.skeleton.rest_offsets[joint]).max() > STILL:
            back = conjugate(body.rest_rotations[body.skeleton.parents[joint]])
            moved.append((joint, rotate(back, offset) / body.stretches[joint]))
    return moved


def _node_motion(body: SkinnedBody, clip: Clip) -> tuple[Positions, Rotations]:
    """Return the pelvis' node in its parent, shape (frames, 3), and how the nodes are turned.

    A node's world rotation is its joint's times how the node is turned at rest.
    """
    rest = body.rest_rotations
    parents = body.skeleton.parents
    above = body.world_from_file
    places = clip.pelvis_positions - above[:3, 3]
    places = places @ np.linalg.inv(above[:3, :3]).T
    axes = above[:3, :3] / np.linalg.norm(above[:3, :3], axis=0)
    rotations = multiply(clip.local_rotations, rest)
    rotations[:, 0] = multiply(conjugate(from_matrix(axes)), rotations[:, 0])
    rotations[:, 1:] = multiply(conjugate(rest[parents[1:]]), rotations[:, 1:])
    return places, continuous(rotations)
