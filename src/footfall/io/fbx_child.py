"""Reads an FBX file in a process of its own, and hands plain arrays back.

The parser is a C library behind bindings that crash the process when an element is fetched twice
(a cached object is returned without a new reference), and the file may be anybody's. So this file
is run by `footfall.io.guarded_server`, and imports nothing of the project.

Facts of the answer: fps, metres_per_unit, up, names, takes, take. Arrays: ``parents`` (nodes,),
``joints`` (flags), ``translations`` (frames, nodes, 3) [m], ``rotations``
(frames, nodes, 4) wxyz, ``scales`` (frames, nodes, 3); each relative to the parent node.
"""

from __future__ import annotations

import ctypes
import importlib
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Answer", "UnreadableError", "load_library", "read_file"]

NONE, BONE, EMPTY = 0, 5, 6
"""ufbx's numbers for the attributes of nodes."""

MOST_FRAMES_PER_SECOND = 10_000

_increase = ctypes.pythonapi.Py_IncRef
_increase.argtypes = [ctypes.py_object]


Answer = tuple[dict[str, Any], dict[str, npt.NDArray[Any]]]
"""Facts by name, and arrays by name."""


class UnreadableError(Exception):
    """What is wrong with the file."""


def load_library() -> None:
    """Import ufbx."""
    importlib.import_module("ufbx")


def read_file(words: list[str], data: bytes, allowed: int) -> Answer:
    """Return the facts and the arrays of a file.

    Args:
        words: The name of the take, if any.
        data: The file.
        allowed: How much memory reading it may take [bytes].

    Raises:
        UnreadableError: If it is damaged.
    """
    return _read(data, allowed, words[0] if words else None)


def _kept(element: Any) -> Any:
    """Return an element that is never freed: see the module's docstring."""
    if element is not None:
        _increase(element)
    return element


def _all(elements: Any) -> list[Any]:
    return [_kept(elements[index]) for index in range(len(elements))]


def _read(data: bytes, allowed: int, take: str | None) -> Answer:
    ufbx: Any = importlib.import_module("ufbx")
    try:
        scene = _kept(
            ufbx.load_memory(
                data,
                target_axes=ufbx.axes_right_handed_y_up,
                target_unit_meters=1.0,
                space_conversion=ufbx.SpaceConversion.MODIFY_GEOMETRY,
                inherit_mode_handling=ufbx.InheritModeHandling.COMPENSATE,
                file_format=ufbx.FileFormat.FBX,
                load_external_files=False,
                ignore_embedded=True,
            )
        )
    except Exception as error:
        # Whatever the binding raises here, the file is what it is about.
        raise UnreadableError(f"is damaged or no FBX file: {error}") from error
    nodes = _all(scene.nodes)
    stacks = _all(scene.anim_stacks)
    stack = _stack(stacks, take)
    settings = scene.settings
    fps = float(settings.frames_per_second)
    motion = _motion(scene, nodes, stack, fps, allowed)
    facts = {
        "fps": fps,
        "metres_per_unit": float(settings.original_unit_meters),
        "up": _axis(settings.axes.up),
        "names": [node.name for node in nodes],
        "takes": [one.name for one in stacks],
        "take": None if stack is None else stack.name,
    }
    return facts, {**_tree(scene, nodes), **motion}


def _axis(direction: int) -> str:
    """Return the letter of one of ufbx's six directions; files that name none have y up."""
    return "xxyyzz"[direction] if 0 <= direction < 6 else "y"


def _stack(stacks: list[Any], take: str | None) -> Any:
    """Return the take that is meant: the one of this name, or the first."""
    if take is None:
        return stacks[0] if stacks else None
    for stack in stacks:
        if stack.name == take:
            return stack
    there = ", ".join(repr(stack.name) for stack in stacks) or "none"
    raise UnreadableError(f"holds no take named {take!r}; there are: {there}")


def _tree(scene: Any, nodes: list[Any]) -> dict[str, npt.NDArray[Any]]:
    """Return the parent of each node, and whether it is a bone or what a skin hangs on.

    Some programs write a skeleton as empties: where there is no bone at all, these are taken.
    """
    parents = np.full(len(nodes), -1, dtype=np.int64)
    joints = np.zeros(len(nodes), dtype=np.bool_)
    for index, node in enumerate(nodes):
        parent = _kept(node.parent)
        if parent is not None:
            parents[index] = int(parent.typed_id)
        joints[index] = int(node.attrib_type) == BONE
    for cluster in _all(scene.skin_clusters):
        bone = _kept(cluster.bone_node)
        if bone is not None:
            joints[int(bone.typed_id)] = True
    if not joints.any():
        plain = [int(node.attrib_type) in (NONE, EMPTY) for node in nodes]
        joints = np.array(plain) & (parents >= 0)
    return {"parents": parents, "joints": joints}


def _motion(
    scene: Any, nodes: list[Any], stack: Any, fps: float, allowed: int
) -> dict[str, npt.NDArray[Any]]:
    """Return every node relative to its parent in every frame of a take."""
    begin, frames = 0.0, 1
    if not 0.0 < fps <= MOST_FRAMES_PER_SECOND:
        raise UnreadableError(
            f"has {fps:g} frames per second; more than 0 and at most {MOST_FRAMES_PER_SECOND} are "
            "possible"
        )
    if stack is not None:
        begin, end = float(stack.time_begin), float(stack.time_end)
        if begin == end:
            # A take that does not say how long it is lasts from its first key to its last.
            ufbx: Any = importlib.import_module("ufbx")
            baked = _kept(ufbx.bake_anim(scene, _kept(stack.anim)))
            begin, end = float(baked.key_time_min), float(baked.key_time_max)
        span = end - begin
        if not (np.isfinite([begin, span]).all() and span >= 0.0):
            raise UnreadableError(
                f"its take runs from {begin:g} s for {span:g} s; a take lasts a finite time"
            )
        frames = round(span * fps) + 1
    if frames * len(nodes) * 80 > allowed:
        raise UnreadableError(
            f"its take is {frames} frames of {len(nodes)} nodes, far more than such a file holds; "
            "cut the take first"
        )
    anim = _kept(scene.anim if stack is None else stack.anim)
    values = np.empty((frames, len(nodes), 10))
    for frame in range(frames):
        time = begin + frame / fps
        for index, node in enumerate(nodes):
            transform = node.evaluate_transform(anim, time)
            t, r, s = transform.translation, transform.rotation, transform.scale
            values[frame, index] = (t.x, t.y, t.z, r.w, r.x, r.y, r.z, s.x, s.y, s.z)
    return {
        "translations": values[..., :3],
        "rotations": values[..., 3:7],
        "scales": values[..., 7:],
    }
