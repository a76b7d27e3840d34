"""Motions of the SMPL family in and out, as AMASS gives them: ``.npz`` with poses and places."""

from __future__ import annotations

import io
from collections.abc import Mapping
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Positions
from footfall.errors import FileFormatError
from footfall.geometry import (
    conjugate,
    from_rotation_vector,
    multiply,
    rotate,
    to_rotation_vector,
)
from footfall.io.atomic import write_atomically
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import BvhRig
from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.frame_rate import conclude_rate
from footfall.io.joint_order import named_like
from footfall.io.numpy_archive import archive_names, read_archive
from footfall.io.smpl_bodies import SMPL_PARENTS, SMPL_TREES, STATURE, approximate_joints
from footfall.io.smpl_model import model_joints
from footfall.io.smpl_stance import conclude_axis, on_the_floor, standing_along_z
from footfall.io.stated import Stated
from footfall.io.units import parse_unit
from footfall.io.up_axis import TO_Y_UP
from footfall.motion import Clip

__all__ = ["is_amass", "load_amass", "read_amass", "save_amass"]

_RATES = ("mocap_framerate", "mocap_frame_rate")
_OWN_JOINTS = "footfall_joints"
_WIDTHS = {3 * len(tree): model for model, tree in SMPL_TREES.items()}


def is_amass(path: Path) -> bool:
    """Whether a ``.npz`` file holds poses and places.

    Raises:
        FileFormatError: If it cannot be read.
    """
    return {"poses", "trans"} <= archive_names(path)


def load_amass(path: Path | str, **known: Any) -> Clip:
    """Read a motion of the SMPL family; arguments and errors are those of `read_amass`."""
    return read_amass(path, **known)[0]


def read_amass(
    path: Path | str,
    *,
    model: Path | str | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a motion of SMPL, SMPL-H or SMPL-X, and conclude what it means.

    Args:
        path: The file, with ``poses``, ``trans``, a rate and perhaps ``betas``.
        model: The user's file of the body model, ``.npz``, from which the joints of this person
            follow. None: an approximate body of ours performs, and is set on the floor.
        unit: Its unit of length, where it is not the metre.
        up: Its upward axis, ``"y"`` or ``"z"``; AMASS has z, other sets have y.
        fps: Its frame rate, where the file says none or a wrong one.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If the file or the model is damaged, or the rate is not known.
        ArgumentError: If `unit`, `up` or `fps` is impossible.
    """
    path = Path(path)
    arrays = read_archive(path, ("poses", "trans", "betas", _OWN_JOINTS, *_RATES))
    poses, places = _motion(arrays, path)
    kind = _WIDTHS[poses.shape[1]]
    rotations = from_rotation_vector(poses.reshape(len(poses), -1, 3))
    rate = conclude_rate(_frame_time(arrays, fps, path), fps)
    joints, whose = _joints(arrays, kind, model, path)
    parents = SMPL_PARENTS[kind]
    offsets = joints - np.where(parents[:, np.newaxis] >= 0, joints[parents], joints)
    places = places + joints[0]
    axis = conclude_axis(rotations, up)
    if model is None and _OWN_JOINTS not in arrays:
        places = on_the_floor(kind, parents, offsets, places, rotations, axis.value)
    if axis.value == "z":
        offsets, rotations = standing_along_z(offsets, rotations)
    rig = BvhRig(
        tuple(SMPL_TREES[kind]), parents, offsets, np.zeros_like(offsets), rotations, {0: places},
        len(poses), Decimal(1) / Decimal(rate.value),
    )  # fmt: skip
    stated = Stated(
        unit=Conclusion(parse_unit("m"), "m, as always in AMASS"),
        up=axis,
        fps=rate,
        frames=Conclusion(len(poses), f"{len(poses)}, as the file holds"),
        notes=(f"body: the {len(parents)} joints of {kind}, {whose}",),
    )
    return clip_from_rig(rig, path, unit=unit, up=up, stated=stated)


def _motion(arrays: Mapping[str, npt.NDArray[Any]], path: Path) -> tuple[Floats, Positions]:
    for name in ("poses", "trans"):
        if name not in arrays or arrays[name].dtype.kind != "f":
            raise FileFormatError(f"is no motion of AMASS: it has no numbers {name!r}", path=path)
    poses, places = arrays["poses"], arrays["trans"]
    if poses.ndim != 2 or poses.shape[1] not in _WIDTHS or len(poses) == 0:
        known = ", ".join(f"{width} ({model})" for width, model in _WIDTHS.items())
        raise FileFormatError(
            f"its poses have shape {poses.shape}; (frames, {known}) are known", path=path
        )
    if places.shape != (len(poses), 3):
        raise FileFormatError(
            f"its trans has shape {places.shape}; {len(poses)} poses need ({len(poses)}, 3)",
            path=path,
        )
    for name, array in (("poses", poses), ("trans", places)):
        wrong = np.argwhere(~(np.abs(array) < 1e12))
        if len(wrong):
            raise FileFormatError(
                f"{name} of frame {wrong[0][0]} holds what is no finite number below 1e12",
                path=path,
            )
    return poses.astype(np.float64), places.astype(np.float64)


def _frame_time(arrays: Mapping[str, npt.NDArray[Any]], fps: float | None, path: Path) -> Decimal:
    """Return the seconds of a frame."""
    for name in _RATES:
        array = arrays.get(name)
        if array is not None and array.size == 1 and array.dtype.kind in "fiu":
            rate = float(array.reshape(-1)[0])
            if not 1e-3 < rate < 1e6:
                raise FileFormatError(f"{name} is {rate:g}; it must be > 0", path=path)
            return Decimal(1) / Decimal(f"{rate:.12g}")
    if fps is None:
        raise FileFormatError(f"says no frame rate ({' or '.join(_RATES)}); pass fps=", path=path)
    return Decimal(1) / 30


def _joints(
    arrays: Mapping[str, npt.NDArray[Any]], kind: str, model: Path | str | None, path: Path
) -> tuple[Positions, str]:
    """Return where the joints stand at rest, shape (joints, 3), and whose they are."""
    if model is not None:
        betas = arrays.get("betas", np.zeros(0))
        shape = betas.reshape(-1, betas.shape[-1])[0] if betas.size and betas.ndim else np.zeros(0)
        if shape.dtype.kind != "f" or not (np.abs(shape) < 1e3).all():
            raise FileFormatError("its betas are no finite numbers below 1000", path=path)
        return model_joints(Path(model), kind, shape), f"from {Path(model).name}"
    own = arrays.get(_OWN_JOINTS)
    if own is None:
        return approximate_joints(kind), (
            f"AN APPROXIMATE BODY of {STATURE:g} m, as no model file was given; it was set on the "
            "floor"
        )
    if (
        own.dtype.kind != "f"
        or own.shape != (len(SMPL_TREES[kind]), 3)
        or not (np.abs(own) < 1e6).all()
    ):
        raise FileFormatError(f"its {_OWN_JOINTS} are no places of its joints", path=path)
    return own.astype(np.float64), "as the file says"


def save_amass(clip: Clip, path: Path | str) -> None:
    """Write a motion of the SMPL family as AMASS does: ``.npz``, z up.

    The joints' places at rest go along under a name of our own, so that `read_amass` gives the
    clip back within 1e-6 m; other readers take them from their model.

    Args:
        clip: The motion, on a body with the joints of SMPL, SMPL-H or SMPL-X.
        path: The file.

    Raises:
        FileFormatError: If the file cannot be written, or the body is another one.
    """
    path = Path(path)
    skeleton = clip.skeleton
    orders = (
        named_like(skeleton, tuple(tree), SMPL_PARENTS[kind]) for kind, tree in SMPL_TREES.items()
    )
    order = next((one for one in orders if one is not None), None)
    if order is None:
        raise FileFormatError(
            f"cannot be written: AMASS has the joints of SMPL, {', '.join(SMPL_TREES['SMPL'])}; "
            f"this body has {', '.join(skeleton.names[:8])}, ...; retarget the motion onto it "
            "first",
            path=path,
        )
    back = conjugate(TO_Y_UP)
    rotations = clip.local_rotations.copy()
    rotations[:, 0] = multiply(back, rotations[:, 0])
    joints = skeleton.rest_offsets.copy()
    for joint, parent in enumerate(skeleton.parents.tolist()):
        if parent >= 0:
            joints[joint] += joints[parent]
    packed = io.BytesIO()
    np.savez_compressed(
        packed,
        poses=to_rotation_vector(rotations[:, order]).reshape(clip.frames, -1),
        trans=rotate(back, clip.pelvis_positions),
        betas=np.zeros(16),
        gender=np.array("neutral"),
        mocap_framerate=np.array(clip.fps),
        footfall_joints=joints[order],
    )
    write_atomically(path, packed.getvalue())
