"""FBX files as text, small enough to be written by hand: what the tests of the reader need."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from footfall.arrays import Floats
from footfall.geometry import to_euler
from footfall.motion import Clip

__all__ = ["fbx_text"]

TICKS = 46186158000

AXES = {"y": (1, 1, 2, 1, 0, 1), "z": (2, 1, 1, -1, 0, 1)}
"""Up, its sign, front, its sign, right, its sign."""


def fbx_text(
    clip: Clip,
    *,
    up: str = "y",
    centimetres: float = 1.0,
    take: str = "Take 001",
    armature_scale: float = 1.0,
    bones: bool = True,
    timed: bool = True,
) -> bytes:
    """Return a clip as an FBX file in centimetres, the pelvis under a node that may be scaled.

    Args:
        clip: The motion; its numbers are written as they are, times 100.
        up: What the file says is up.
        centimetres: What the file says its unit is [cm].
        take: What the take is called.
        armature_scale: Of the node above the pelvis.
        bones: Whether joints are bones, or mere empties.
        timed: Whether the take says how long it is.
    """
    scale = 100.0 / armature_scale
    objects = [_model(1, "Armature", [0.0, 0.0, 0.0], armature_scale, "Null")]
    links = ["OO,1,0", "OO,500,0", "OO,501,500"]
    kind = "LimbNode" if bones else "Null"
    stop = _stop(clip) if timed else ""
    objects.append(f'AnimationStack: 500, "AnimStack::{take}", "" {{ {stop} }}')
    objects.append('AnimationLayer: 501, "AnimLayer::Base", "" { }')
    places = np.broadcast_to(clip.skeleton.rest_offsets, (clip.frames, clip.skeleton.count, 3))
    angles = np.degrees(np.unwrap(to_euler("ZYX", clip.local_rotations), axis=0))[..., ::-1]
    for joint, name in enumerate(clip.skeleton.names):
        key = 1000 + joint
        parent = int(clip.skeleton.parents[joint])
        objects.append(_model(key, name, scale * places[0, joint], 1.0, kind))
        links.append(f"OO,{key},{1000 + parent if parent >= 0 else 1}")
        if bones:
            objects.append(f'NodeAttribute: {2000 + joint}, "NodeAttribute::", "LimbNode" {{ }}')
            links.append(f"OO,{2000 + joint},{key}")
        moves = {"Lcl Rotation": angles[:, joint]}
        if joint == 0:
            moves["Lcl Translation"] = scale * clip.pelvis_positions
        for number, (what, values) in enumerate(moves.items()):
            node = 10_000 + 100 * joint + 10 * number
            objects.append(f'AnimationCurveNode: {node}, "AnimCurveNode::x", "" {{ }}')
            links += [f"OO,{node},501", f'OP,{node},{key}, "{what}"']
            for axis in range(3):
                objects.append(_curve(node + axis + 1, values[:, axis], clip.fps))
                links.append(f'OP,{node + axis + 1},{node}, "d|{"XYZ"[axis]}"')
    return _file(objects, links, up, centimetres)


def _stop(clip: Clip) -> str:
    times = {"LocalStart": 0, "LocalStop": round(clip.duration * TICKS)}
    return _properties([f'"{name}", "KTime", "Time", "",{time}' for name, time in times.items()])


def _properties(lines: Iterable[str]) -> str:
    return "Properties70: {\n" + "".join(f"P: {line}\n" for line in lines) + "}\n"


def _model(key: int, name: str, place: Floats | list[float], scale: float, kind: str) -> str:
    x, y, z = (float(value) for value in place)
    properties = _properties(
        [
            f'"Lcl Translation", "Lcl Translation", "", "A",{x!r},{y!r},{z!r}',
            f'"Lcl Scaling", "Lcl Scaling", "", "A",{scale!r},{scale!r},{scale!r}',
        ]
    )
    return f'Model: {key}, "Model::{name}", "{kind}" {{ Version: 232\n{properties} }}'


def _curve(key: int, values: Floats, fps: float) -> str:
    times = ",".join(str(round(frame / fps * TICKS)) for frame in range(len(values)))
    numbers = ",".join(repr(float(value)) for value in values)
    count = len(values)
    return (
        f'AnimationCurve: {key}, "AnimCurve::", "" {{\nKeyVer: 4008\n'
        f"KeyTime: *{count} {{ a: {times} }}\nKeyValueFloat: *{count} {{ a: {numbers} }}\n"
        f"KeyAttrFlags: *1 {{ a: 4 }}\nKeyAttrDataFloat: *4 {{ a: 0,0,0,0 }}\n"
        f"KeyAttrRefCount: *1 {{ a: {count} }}\n}}"
    )


def _file(objects: list[str], links: list[str], up: str, centimetres: float) -> bytes:
    names = ("UpAxis", "UpAxisSign", "FrontAxis", "FrontAxisSign", "CoordAxis", "CoordAxisSign")
    settings = [
        f'"{name}", "int", "Integer", "",{value}'
        for name, value in zip(names, AXES[up], strict=True)
    ]
    settings.append(f'"UnitScaleFactor", "double", "Number", "",{centimetres!r}')
    settings.append('"TimeMode", "enum", "", "",6')
    connections = "".join(f'C: "{link[:2]}"{link[2:]}\n' for link in links)
    return (
        "; FBX 7.4.0 project file\nFBXHeaderExtension: { FBXHeaderVersion: 1003\n"
        "FBXVersion: 7400 }\n"
        f"GlobalSettings: {{ Version: 1000\n{_properties(settings)} }}\n"
        "Objects: {\n" + "\n".join(objects) + "\n}\nConnections: {\n" + connections + "}\n"
    ).encode()
