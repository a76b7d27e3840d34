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
import pytest
from tests.io.small_biped import BIPED, biped_clip
from tests.io.small_fbx import fbx_text
from tests.io.small_usd import usd_text

from footfall.geometry import from_euler
from footfall.io import (
    load,
    load_skinned,
    load_supports,
    save,
    save_amass,
    save_deepmimic,
    save_gltf,
    save_native,
    save_supports,
)
from footfall.io.deepmimic_body import HUMANOID, read_character
from footfall.io.smpl_bodies import SMPL_PARENTS, SMPL_TREES, approximate_joints
from footfall.io.smpl_model import model_joints
from footfall.motion import Clip
from footfall.robots import (
    humanoid_mjcf,
    load_robot,
    load_robot_motion,
    our_robot,
    perform_on_robot,
    save_robot_motion,
)
from footfall.samples import sample
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
    "fbx": ("a.fbx", load),
    "usda": ("a.usda", load),
    "usdc": ("a.usdc", load),
    "supports": ("a.supports", load_supports),
    "csv": ("s.csv", load_supports),
    "parquet": ("s.parquet", load_supports),
    "mjcf": ("r.xml", load_robot),
    "robot": ("r.npz", load_robot_motion),
    "scenario": ("a.toml", load_scenario),
}
"""The name of a file of each form, and its reader."""


LIBRARIES = {
    "fbx": "ufbx", "usda": "pxr", "usdc": "pxr", "parquet": "pyarrow", "mjcf": "mujoco",
    "robot": "mujoco",
}  # fmt: skip
"""What must be installed for a form."""


def small_bytes(form: str, folder: Path) -> bytes:
    """Return a small valid file of a form; `folder` is written to on the way."""
    if form in LIBRARIES:
        pytest.importorskip(LIBRARIES[form])
    path = folder / f"small_{FORMS[form][0]}"
    if form in WRITERS:
        WRITERS[form](path)
        return path.read_bytes()
    if form == "gltf":
        save_gltf(biped_clip(), path.with_suffix(".glb"))
        return gltf_bytes(path.with_suffix(".glb"))
    return {
        "bvh": BIPED.encode(),
        "fbx": fbx_text(biped_clip(frames=4)),
        "usda": usd_text(biped_clip(frames=4)),
        "model": model_bytes(),
        "mjcf": humanoid_mjcf().encode(),
        "character": json.dumps(CHARACTER, indent=1).encode(),
        "supports": b"# by hand\ncyclic\nR 0.383\nD 0.117\nL 0.383\nD 0.117\n",
        "scenario": SCENARIO.encode(),
    }[form]


def _save_moves(path: Path) -> None:
    robot = our_robot()
    save_robot_motion(perform_on_robot(robot, *sample("run")), robot, path)


LABELS = SupportSequence.parse("R.4 D.1 L.4 D.1*")

WRITERS: dict[str, Callable[[Path], None]] = {
    "native": lambda path: save_native(
        biped_clip(), path, supports=SupportSequence.parse("R.1 D.1 L.1*")
    ),
    "glb": lambda path: save_gltf(biped_clip(), path),
    "skin": lambda path: save_gltf(biped_clip(), path),
    "amass": lambda path: save_amass(smpl_clip(), path),
    "deepmimic": lambda path: save_deepmimic(humanoid_clip(), path),
    "usdc": lambda path: save(biped_clip(frames=4), path),
    "csv": lambda path: save_supports(LABELS, path),
    "parquet": lambda path: save_supports(LABELS, path),
    "robot": _save_moves,
}
"""What writes a small valid file of a form."""
