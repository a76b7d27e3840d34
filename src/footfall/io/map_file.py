"""A map file: corrections to what drives the joints of a body, as TOML.

[joints]
LeftHand = "LeftWrist"                # body joint = reference joint
Spine1 = ["Chest", "Chest2", 0.5]     # half way between two reference joints
Tail = "rest"                         # stays as at rest, relative to its parent
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any, cast

from footfall.errors import FileFormatError
from footfall.skeleton.correspondence import Correction

__all__ = ["load_map"]

REST = "rest"
"""What drives a joint that is not driven."""


def load_map(path: Path) -> dict[str, Correction | None]:
    """Return the corrections of a map file, for `map_body`.

    Args:
        path: The file.

    Raises:
        FileFormatError: If it cannot be read or says something else.
    """
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise FileFormatError(f"cannot be read as TOML: {error}", path=path) from error
    unknown = sorted(set(content) - {"joints"})
    joints: Any = content.get("joints")
    if unknown or not isinstance(joints, dict):
        what = f"it has {unknown[0]!r}" if unknown else "it has none"
        raise FileFormatError(f"a map file has one table, [joints]; {what}", path=path)
    table = cast(dict[str, Any], joints)
    return {name: _correction(name, value, path) for name, value in table.items()}


def _correction(name: str, value: Any, path: Path) -> Correction | None:
    if value == REST:
        return None
    if isinstance(value, str):
        return value, value, 0.0
    parts = cast(list[Any], value) if isinstance(value, list) else []
    if len(parts) == 3 and isinstance(parts[0], str) and isinstance(parts[1], str):
        fraction = parts[2]
        if isinstance(fraction, int | float) and not isinstance(fraction, bool):
            return parts[0], parts[1], float(fraction)
    raise FileFormatError(
        f"{name!r} is {value!r}; it must be a joint of the reference body, two of them and a "
        'fraction such as ["Chest", "Chest2", 0.5], or "rest"',
        path=path,
    )
