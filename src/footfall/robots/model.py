"""A robot: an MJCF model, and which of its bodies are the limbs of a person."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Positions
from footfall.errors import FileFormatError, SkeletonError
from footfall.extras import extra_module
from footfall.io.raw_file import decoded, read_bytes
from footfall.robots.humanoid import humanoid_mjcf
from footfall.skeleton import Anatomy, Skeleton, find_anatomy

__all__ = ["Robot", "load_robot", "our_robot", "to_mujoco", "to_ours"]

FREE, HINGE, SLIDE = 0, 3, 2
"""MuJoCo's numbers for kinds of joints."""


def to_ours(vectors: Positions) -> Positions:
    """Return vectors of MuJoCo's axes (x forward, z up) in ours (z forward, y up)."""
    return vectors[..., [1, 2, 0]]


def to_mujoco(vectors: Positions) -> Positions:
    """Return vectors of our axes in MuJoCo's."""
    return vectors[..., [2, 0, 1]]


@dataclass(frozen=True, eq=False)
class Robot:
    """A model whose root is free and whose joints turn about axes."""

    name: str
    """What the model calls itself."""

    digest: str
    """SHA-256 of the model's text."""

    mujoco: Any
    """The library."""

    model: Any
    """Its `MjModel`."""

    skeleton: Skeleton
    """Its bodies as joints, where all hinges are at zero, in our axes [m]."""

    anatomy: Anatomy
    """Which of them are legs, arms and head."""

    hinges: tuple[str, ...]
    """Names of its hinges, in the order of `qpos` behind the root's seven numbers."""

    @property
    def sole_height(self) -> float:
        """How high the ankles are over the soles where all hinges are at zero [m]."""
        data = self.mujoco.MjData(self.model)
        self.mujoco.mj_kinematics(self.model, data)
        heights: list[float] = []
        for leg in self.anatomy.legs:
            body = leg.ankle + 1
            for geom in np.flatnonzero(self.model.geom_bodyid == body).tolist():
                center, half = self.model.geom_aabb[geom, :3], self.model.geom_aabb[geom, 3:]
                up = data.geom_xmat[geom].reshape(3, 3)[2]
                lowest = data.geom_xpos[geom, 2] + up @ center - np.abs(up) @ half
                heights.append(float(data.xpos[body, 2] - lowest))
        return max(heights, default=0.0)


def our_robot(stature: float = 1.75) -> Robot:
    """Return the project's own humanoid; see `humanoid_mjcf`.

    Raises:
        MissingExtraError: If MuJoCo is not installed.
        ArgumentError: If `stature` is out of its range.
    """
    return _robot(humanoid_mjcf(stature), Path("footfall-humanoid.xml"))


def load_robot(path: Path | str) -> Robot:
    """Read a humanoid robot from an MJCF file.

    Raises:
        FileFormatError: If it is none: no free root, other joints than hinges, or no two legs.
        MissingExtraError: If MuJoCo is not installed.
    """
    path = Path(path)
    return _robot(decoded(read_bytes(path)), path)


def _robot(text: str, path: Path) -> Robot:
    mujoco = extra_module("mujoco", f"reading {path.name}", extra="robot")
    told_before = mujoco.get_mju_user_warning()
    # Else a warning is written to a log in the folder that the user happens to be in.
    mujoco.set_mju_user_warning(_ignored)
    try:
        if path.exists():
            # Meshes and included files are found from where the model is.
            model: Any = mujoco.MjModel.from_xml_path(str(path))
        else:
            model = mujoco.MjModel.from_xml_string(text)
    except (ValueError, mujoco.FatalError) as error:
        told = " ".join(str(error).split())[:200]
        raise FileFormatError(f"is no MJCF model: {told}", path=path) from error
    finally:
        mujoco.set_mju_user_warning(told_before)
    kinds = model.jnt_type.tolist()
    if not kinds or kinds[0] != FREE or any(kind != HINGE for kind in kinds[1:]):
        raise FileFormatError(
            f"has joints of the kinds {kinds[:8]}; a humanoid has a free root ({FREE}) first, and "
            f"then hinges ({HINGE})",
            path=path,
        )
    if not (np.isfinite(model.jnt_range).all() and np.isfinite(model.jnt_axis).all()):
        raise FileFormatError("has a hinge whose axis or range is not finite", path=path)
    try:
        skeleton = _skeleton(mujoco, model)
        return Robot(
            name=str(model.names.split(b"\0", 1)[0].decode(errors="replace")),
            digest=hashlib.sha256(text.encode()).hexdigest(),
            mujoco=mujoco,
            model=model,
            skeleton=skeleton,
            anatomy=find_anatomy(skeleton),
            hinges=tuple(str(model.joint(index).name) for index in range(1, model.njnt)),
        )
    except SkeletonError as error:
        raise FileFormatError(f"is no humanoid: {error}", path=path) from error
    except UnicodeDecodeError as error:
        raise FileFormatError(f"has names that are no UTF-8: {error}", path=path) from error


def _ignored(_: str) -> None:
    """Let a warning of the library pass: what matters is refused in words of our own."""


def _skeleton(mujoco: Any, model: Any) -> Skeleton:
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    places = to_ours(np.array(data.xpos[1:]))
    parents = np.array(model.body_parentid[1:], dtype=np.int64) - 1
    # Places beyond all numbers are told by the skeleton.
    with np.errstate(invalid="ignore", over="ignore"):
        offsets = np.where((parents < 0)[:, np.newaxis], 0.0, places - places[parents])
    names = tuple(str(model.body(index).name) for index in range(1, model.nbody))
    return Skeleton(names, parents, offsets)
