"""A motion of a robot: what its joints are to do, and what it stands on, frame by frame.

The file is a plain ``.npz``, readable by anybody with NumPy alone:

- ``header``: UTF-8 JSON as bytes: format, version, fps, joint_names, model, model_sha256, name;
- ``qpos`` (frames, nq): root position [m], root quaternion wxyz, hinges [rad], as MuJoCo has them;
- ``qvel`` (frames, nv): velocities, also as MuJoCo has them, from each frame to the next;
- ``joint_targets`` (frames, hinges) [rad]: the hinges alone, in the order of ``joint_names``;
- ``left`` and ``right`` (frames,): whether each foot carries; ``supports`` (frames,): R, L, D or -.
"""

from __future__ import annotations

import io
import json
import tokenize
import zipfile
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from footfall.arrays import Floats, Supports
from footfall.errors import FileFormatError
from footfall.io.atomic import write_atomically
from footfall.io.raw_file import read_bytes
from footfall.robots.model import Robot
from footfall.support import Support

__all__ = ["RobotMotion", "load_robot_motion", "save_robot_motion"]

FORMAT = "footfall robot motion"
VERSION = 1

MOST_UNFOLDED, TIMES_UNFOLDED = 48_000_000, 16
"""What a file may unfold to: so much, and so much per byte [bytes]."""


@dataclass(frozen=True, eq=False)
class RobotMotion:
    """What a robot is to do."""

    qpos: Floats
    """Root and hinges of every frame, shape (frames, nq)."""

    qvel: Floats
    """Their velocities, shape (frames, nv)."""

    supports: Supports
    """Values of `Support`, shape (frames,)."""

    fps: float
    """Frames per second."""

    joint_names: tuple[str, ...]
    """Of the hinges, in the order of ``qpos[:, 7:]``."""

    name: str
    """What the motion is called."""


def save_robot_motion(motion: RobotMotion, robot: Robot, path: Path) -> None:
    """Write the motion of a robot.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    header = {
        "format": FORMAT,
        "version": VERSION,
        "fps": motion.fps,
        "joint_names": list(motion.joint_names),
        "model": robot.name,
        "model_sha256": robot.digest,
        "name": motion.name,
    }
    kinds = [Support(support) for support in motion.supports.tolist()]
    packed = io.BytesIO()
    np.savez_compressed(
        packed,
        header=np.frombuffer(json.dumps(header).encode(), dtype=np.uint8),
        qpos=motion.qpos,
        qvel=motion.qvel,
        joint_targets=motion.qpos[:, 7:],
        left=np.array([kind.left for kind in kinds]),
        right=np.array([kind.right for kind in kinds]),
        supports=np.array([kind.symbol for kind in kinds]),
    )
    write_atomically(path, packed.getvalue())


def load_robot_motion(path: Path | str) -> RobotMotion:
    """Read the motion of a robot.

    Raises:
        FileFormatError: If the file is none of this project's, or is damaged.
    """
    path = Path(path)
    data = read_bytes(path)
    try:
        _check_size(data)
        with np.load(io.BytesIO(data), allow_pickle=False) as stored:
            header: Any = json.loads(stored["header"].tobytes())
            _check_header(header, path)
            arrays = {
                name: _numbers(stored[name], name) for name in ("qpos", "qvel", "left", "right")
            }
    except FileFormatError:
        raise
    except (
        OSError,
        EOFError,
        KeyError,
        MemoryError,
        SyntaxError,
        TypeError,
        ValueError,
        RuntimeError,
        tokenize.TokenError,
        zipfile.BadZipFile,
        zlib.error,
    ) as error:
        told = " ".join(str(error).split())[:120]
        raise FileFormatError(f"is damaged or no motion of a robot: {told}", path=path) from error
    return _checked(header, arrays, path)


def _check_size(data: bytes) -> None:
    """Refuse what unfolds to far more than its size, before it does."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        unfolded = sum(entry.file_size for entry in archive.infolist())
    if unfolded > MOST_UNFOLDED + TIMES_UNFOLDED * len(data):
        raise ValueError(f"it unfolds from {len(data)} to {unfolded} bytes")


def _numbers(array: Any, name: str) -> Floats:
    if array.dtype.kind not in "bf" or not np.isfinite(array).all():
        raise TypeError(f"{name} holds {array.dtype}, or what is not finite")
    return np.asarray(array, dtype=np.float64)


def _check_header(header: Any, path: Path) -> None:
    facts = cast("dict[str, Any]", header) if isinstance(header, dict) else {}
    if (facts.get("format"), facts.get("version")) != (FORMAT, VERSION):
        raise FileFormatError(
            f"is no motion of a robot of version {VERSION}; write one with footfall robot",
            path=path,
        )


def _checked(header: Any, arrays: dict[str, Floats], path: Path) -> RobotMotion:
    qpos = arrays["qpos"]
    names = tuple(str(name) for name in header.get("joint_names", ()))
    fps = header.get("fps")
    if qpos.ndim != 2 or qpos.shape[1] != 7 + len(names) or not len(qpos):
        raise FileFormatError(
            f"has qpos of shape {qpos.shape}; {len(names)} hinges need (frames, {7 + len(names)})",
            path=path,
        )
    if not isinstance(fps, int | float) or not 0.0 < fps < 1e6:
        raise FileFormatError(f"has {fps} frames per second; it must be > 0", path=path)
    if arrays["left"].shape != (len(qpos),) or arrays["right"].shape != (len(qpos),):
        raise FileFormatError("has not as many labels as frames", path=path)
    lengths = np.linalg.norm(qpos[:, 3:7], axis=1)
    if np.abs(lengths - 1.0).max() > 1e-3:
        raise FileFormatError("has a root quaternion that is not of unit length", path=path)
    feet = zip(arrays["left"].tolist(), arrays["right"].tolist(), strict=True)
    supports = np.array([int(Support.from_feet(bool(one), bool(other))) for one, other in feet])
    return RobotMotion(
        qpos, arrays["qvel"], supports, float(fps), names, str(header.get("name", "robot"))
    )
