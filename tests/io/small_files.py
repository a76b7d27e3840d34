"""A small valid file of each form that is read, and what reads it."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

import io
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from tests.io.small_biped import BIPED, biped_clip

from footfall.geometry import from_euler
from footfall.io import (
    load,
    load_skinned,
    load_supports,
    save_amass,
    save_deepmimic,
    save_gltf,
    save_native,
)
from footfall.io.deepmimic_body import HUMANOID, read_character
from footfall.io.smpl_bodies import SMPL_PARENTS, SMPL_TREES, approximate_joints
from footfall.io.smpl_model import model_joints
from footfall.motion import Clip
from footfall.scenario.cue_sheet import load_scenario
from footfall.skeleton import Skeleton
from footfall.support import SupportSequence

__all__ = ["FORMS", "gltf_bytes", "humanoid_clip", "model_bytes", "small_bytes", "smpl_clip"]

SCENARIO = """duration = 3.0

[[action]]
name = "walk"
motion = "sample:walk"
priority = 2

[[cue]]
at = 0.5
start = "walk"
"""

CHARACTER = {
    "Skeleton": {
        "Joints": [
            {"ID": 0, "Name": "root", "Type": "none", "Parent": -1, "AttachX": 0.0},
            {"ID": 1, "Name": "knee", "Type": "revolute", "Parent": 0, "AttachY": -0.4},
            {"ID": 2, "Name": "foot", "Type": "fixed", "Parent": 1, "AttachY": -0.4},
        ]
    },
    "BodyDefs": [
        {"Shape": "sphere"},
        {"Shape": "capsule"},
        {"Shape": "box", "AttachX": 0.04, "Param0": 0.2, "Param1": 0.06},
    ],
}


def _turns(frames: int, joints: int) -> npt.NDArray[np.float64]:
    """Return rotations that differ everywhere, all about z, shape (frames, joints, 4)."""
    angles = 0.02 * np.arange(frames)[:, np.newaxis] + 0.01 * np.arange(joints)
    return from_euler("Z", angles[..., np.newaxis])


def humanoid_clip(frames: int = 3) -> Clip:
    """Return a motion of DeepMimic's humanoid."""
    body = Skeleton(HUMANOID.names, HUMANOID.parents, HUMANOID.offsets, HUMANOID.tips)
    places: Any = np.tile([0.0, 0.85, 0.0], (frames, 1)) + 0.01 * np.arange(frames)[:, np.newaxis]
    return Clip(body, places, _turns(frames, body.count), 30.0)


def smpl_clip(model: str = "SMPL body", frames: int = 3) -> Clip:
    """Return a motion of the approximate body of a SMPL model."""
    joints = approximate_joints(model)
    parents = SMPL_PARENTS[model]
    offsets = joints - np.where(parents[:, np.newaxis] >= 0, joints[parents], joints)
    body = Skeleton(tuple(SMPL_TREES[model]), parents, offsets)
    places: Any = np.tile([0.1, 0.95, 0.0], (frames, 1)) + 0.01 * np.arange(frames)[:, np.newaxis]
    return Clip(body, places, _turns(frames, body.count), 60.0)


def model_bytes(model: str = "SMPL", scale: float = 1.1) -> bytes:
    """Return a body model file: a vertex a joint, the second shape makes it taller."""
    joints = scale * approximate_joints(model)
    directions = np.zeros((len(joints), 3, 10))
    directions[:, :, 1] = 0.1 * joints
    parents = SMPL_PARENTS[model].astype(np.uint32)
    packed = io.BytesIO()
    np.savez(
        packed,
        J_regressor=np.eye(len(joints)),
        v_template=joints,
        shapedirs=directions,
        kintree_table=np.stack([parents, np.arange(len(joints), dtype=np.uint32)]),
    )
    return packed.getvalue()


def gltf_bytes(path: Path) -> bytes:
    """Return the small biped as .gltf with its buffer inside, from a .glb file."""
    import base64

    data = path.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    document: dict[str, Any] = json.loads(data[20 : 20 + size])
    body = base64.b64encode(data[28 + size :]).decode()
    document["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{body}"
    return json.dumps(document, indent=1).encode()


FORMS: dict[str, tuple[str, Callable[[Path], object]]] = {
    "bvh": ("a.bvh", load),
    "native": ("a.npz", load),
    "glb": ("a.glb", load),
    "skin": ("s.glb", load_skinned),
    "gltf": ("a.gltf", load),
    "amass": ("b.npz", load),
    "model": ("m.npz", lambda path: model_joints(path, "SMPL", np.ones(10))),
    "deepmimic": ("a.txt", load),
    "character": ("c.txt", read_character),
    "supports": ("a.supports", load_supports),
    "scenario": ("a.toml", load_scenario),
}
"""The name of a file of each form, and its reader."""


def small_bytes(form: str, folder: Path) -> bytes:
    """Return a small valid file of a form; `folder` is written to on the way."""
    path = folder / f"small_{FORMS[form][0]}"
    if form == "bvh":
        return BIPED.encode()
    if form == "native":
        save_native(biped_clip(), path, supports=SupportSequence.parse("R.1 D.1 L.1*"))
    elif form in ("glb", "skin", "gltf"):
        save_gltf(biped_clip(), path)
        if form == "gltf":
            return gltf_bytes(path)
    elif form == "amass":
        save_amass(smpl_clip(), path)
    elif form == "deepmimic":
        save_deepmimic(humanoid_clip(), path)
    else:
        return {
            "model": model_bytes(),
            "character": json.dumps(CHARACTER, indent=1).encode(),
            "supports": b"# by hand\ncyclic\nR 0.383\nD 0.117\nL 0.383\nD 0.117\n",
            "scenario": SCENARIO.encode(),
        }[form]
    return path.read_bytes()
