"""The project's own files: a clip, exactly as it is, and its supports, in one ``.npz``.

Plain NumPy arrays and one JSON header, readable by anybody with NumPy alone:

- ``header``: UTF-8 JSON as bytes: format, version, joint names, fps, cyclic, name, provenance,
  supports (or null);
- ``parents`` (joints,), ``rest_offsets`` and ``tip_offsets`` (joints, 3) [m];
- ``pelvis_positions`` (frames, 3) [m], ``local_rotations`` (frames, joints, 4), wxyz.

Version 1 is the first. A reader refuses versions that it does not know.
"""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

import numpy as np

from footfall.errors import ClipError, FileFormatError, SkeletonError, SupportSequenceError
from footfall.io.atomic import write_atomically
from footfall.io.numpy_archive import read_archive
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["load_native", "load_native_supports", "save_native"]

FORMAT = "footfall clip"
VERSION = 1
_ARRAYS = (
    "parents",
    "rest_offsets",
    "tip_offsets",
    "pelvis_positions",
    "local_rotations",
)


def save_native(clip: Clip, path: Path | str, *, supports: SupportSequence | None = None) -> None:
    """Write a clip, and its supports if given, so that reading gives the very same numbers.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    header = {
        "format": FORMAT,
        "version": VERSION,
        "names": list(clip.skeleton.names),
        "fps": clip.fps,
        "cyclic": clip.cyclic,
        "name": clip.name,
        "provenance": list(clip.provenance),
        "supports": None if supports is None else _supports_to_json(supports),
    }
    packed = io.BytesIO()
    np.savez_compressed(
        packed,
        header=np.frombuffer(json.dumps(header).encode(), dtype=np.uint8),
        parents=clip.skeleton.parents,
        rest_offsets=clip.skeleton.rest_offsets,
        tip_offsets=clip.skeleton.tip_offsets,
        pelvis_positions=clip.pelvis_positions,
        local_rotations=clip.local_rotations,
    )
    write_atomically(Path(path), packed.getvalue())


def _supports_to_json(supports: SupportSequence) -> dict[str, Any]:
    return {
        "phases": [[phase.support.symbol, phase.duration] for phase in supports.phases],
        "cyclic": supports.cyclic,
        "start": supports.start,
    }


def load_native(path: Path | str) -> Clip:
    """Read a clip.

    Raises:
        FileFormatError: If the file is none of this project's, is damaged, or is of a version
            that is not known.
    """
    path = Path(path)
    header, arrays = _read(path)
    try:
        skeleton = Skeleton(
            tuple(_texts(header["names"])),
            arrays["parents"],
            arrays["rest_offsets"],
            arrays["tip_offsets"],
        )
        return Clip(
            skeleton,
            arrays["pelvis_positions"],
            arrays["local_rotations"],
            float(header["fps"]),
            bool(header["cyclic"]),
            str(header["name"]),
            tuple(_texts(header["provenance"])),
        )
    except (SkeletonError, ClipError) as error:
        raise FileFormatError(str(error), path=path) from error
    except (KeyError, TypeError, ValueError, IndexError) as error:
        raise _damaged(path, error) from error


def load_native_supports(path: Path | str) -> SupportSequence | None:
    """Read the supports that travel with a clip; None where there are none.

    Raises:
        FileFormatError: As `load_native`.
    """
    path = Path(path)
    header, _ = _read(path)
    supports = header.get("supports")
    if supports is None:
        return None
    try:
        phases = tuple(
            SupportPhase(Support.from_symbol(symbol), float(duration))
            for symbol, duration in supports["phases"]
        )
        return SupportSequence(phases, bool(supports["cyclic"]), float(supports["start"]))
    except SupportSequenceError as error:
        raise FileFormatError(f"its supports: {error}", path=path) from error
    except (KeyError, TypeError, ValueError) as error:
        raise _damaged(path, error) from error


def _texts(items: Any) -> list[str]:
    texts: list[Any] = list(items)
    if isinstance(items, str) or not all(isinstance(text, str) for text in texts):
        raise TypeError("a list of texts is expected")
    return texts


def _read(path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the checked header and the arrays."""
    stored = read_archive(path, ("header", *_ARRAYS))
    if "header" not in stored:
        raise FileFormatError("is no clip of this project: it has no header", path=path)
    try:
        header: Any = json.loads(stored["header"].tobytes())
        _check_header(header, path)
        arrays = {name: _checked(name, stored[name]) for name in _ARRAYS}
    except FileFormatError:
        raise
    except (KeyError, TypeError, ValueError, RecursionError) as error:
        raise _damaged(path, error) from error
    return header, arrays


def _checked(name: str, array: Any) -> Any:
    """Return an array that holds numbers of the right kind."""
    kind = np.integer if name == "parents" else np.floating
    if not np.issubdtype(array.dtype, kind):
        raise TypeError(f"{name} holds {array.dtype}, not {kind.__name__} numbers")
    return array


def _check_header(header: Any, path: Path) -> None:
    if not isinstance(header, dict) or header.get("format") != FORMAT:  # pyright: ignore[reportUnknownMemberType]
        raise FileFormatError(
            f"is no clip of this project: its header is not {FORMAT!r}", path=path
        )
    version: Any = header.get("version")  # pyright: ignore[reportUnknownMemberType, reportUnknownVariableType]
    if version != VERSION:
        raise FileFormatError(
            f"is of version {version}; this program reads version {VERSION}", path=path
        )


def _damaged(path: Path, error: Exception) -> FileFormatError:
    detail = " ".join(str(error).split())[:120]
    return FileFormatError(f"is damaged or no clip of this project: {detail}", path=path)
