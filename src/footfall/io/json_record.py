"""JSON that a stranger wrote: every value is asked for by its kind, and refused with its place."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn, cast

import numpy as np

from footfall.arrays import Floats
from footfall.errors import FileFormatError

__all__ = ["JsonRecord", "parse_json"]

GREATEST = 1e12
"""Numbers beyond it are refused: no motion has them, and their squares lose everything."""


def parse_json(data: bytes, path: Path) -> JsonRecord:
    """Read the bytes of a JSON object.

    Args:
        data: UTF-8 text, with or without a byte order mark.
        path: The file, for messages.

    Raises:
        FileFormatError: If it is no JSON, or no object.
    """
    try:
        content: Any = json.loads(data.decode("utf-8-sig"), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        detail = " ".join(str(error).split())[:120]
        raise FileFormatError(f"is no JSON: {detail}", path=path) from error
    if not isinstance(content, dict):
        raise FileFormatError("is JSON, but no object; one is expected, {...}", path=path)
    return JsonRecord(cast(dict[str, Any], content), "", path)


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is no number of JSON")


@dataclass(frozen=True, slots=True)
class JsonRecord:
    """An object of a JSON file, and where it stands in it."""

    content: dict[str, Any]
    """Its members."""

    where: str
    """Its place, such as ``nodes[3]``; empty for the whole file."""

    path: Path
    """The file, for messages."""

    def fail(self, name: str, problem: str) -> NoReturn:
        """Raise a FileFormatError about a member."""
        place = f"{self.where}.{name}" if self.where and name else self.where or name
        raise FileFormatError(f"{place} {problem}", path=self.path)

    def has(self, name: str) -> bool:
        """Whether there is such a member, and it is not null."""
        return self.content.get(name) is not None

    def integer(
        self, name: str, default: int | None = None, *, least: int = 0, below: int = 2**53
    ) -> int:
        """Return a whole number within [least, below); `default` where there is none."""
        value = self.content.get(name)
        if value is None and default is not None:
            return default
        if isinstance(value, float) and value.is_integer() and abs(value) < 2**53:
            value = int(value)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value < below:
            self.fail(
                name, f"is {_shown(value)}; a whole number within {least}..{below - 1} is expected"
            )
        return value

    def number(self, name: str, default: float | None = None) -> float:
        """Return a finite number; `default` where there is none."""
        value = self.content.get(name)
        if value is None and default is not None:
            return default
        if value is None or not _is_number(value):
            self.fail(name, f"is {_shown(value)}; a finite number below 1e12 is expected")
        return float(value)

    def numbers(self, name: str, count: int, default: tuple[float, ...] | None = None) -> Floats:
        """Return this many finite numbers; `default` where there are none, shape (count,)."""
        value = self.content.get(name)
        if value is None and default is not None:
            return np.array(default)
        if not isinstance(value, list):
            self.fail(name, f"is {_shown(value)}; {count} numbers are expected")
        items = cast(list[Any], value)
        if len(items) != count or not all(_is_number(item) for item in items):
            self.fail(name, f"is {_shown(items)}; {count} finite numbers below 1e12 are expected")
        return np.array([float(item) for item in items])

    def text(self, name: str, default: str | None = None) -> str:
        """Return a text; `default` where there is none."""
        value = self.content.get(name)
        if value is None and default is not None:
            return default
        if not isinstance(value, str):
            self.fail(name, f"is {_shown(value)}; a text is expected")
        return value

    def flag(self, name: str) -> bool:
        """Return true or false; false where there is none."""
        value = self.content.get(name, False)
        if not isinstance(value, bool):
            self.fail(name, f"is {_shown(value)}; true or false is expected")
        return value

    def indices(self, name: str, below: int) -> list[int]:
        """Return whole numbers within [0, below); none where there are none."""
        value = self.content.get(name)
        if value is None:
            return []
        items = cast(list[Any], value) if isinstance(value, list) else None
        if items is None or not all(type(item) is int and 0 <= item < below for item in items):
            self.fail(name, f"is {_shown(value)}; whole numbers below {below} are expected")
        return items

    def record(self, name: str) -> JsonRecord | None:
        """Return an object; None where there is none."""
        value = self.content.get(name)
        if value is None:
            return None
        if not isinstance(value, dict):
            self.fail(name, f"is {_shown(value)}; an object is expected")
        return JsonRecord(cast(dict[str, Any], value), self._inside(name), self.path)

    def records(self, name: str) -> list[JsonRecord]:
        """Return a list of objects; empty where there is none."""
        value = self.content.get(name)
        if value is None:
            return []
        if not isinstance(value, list):
            self.fail(name, f"is {_shown(value)}; a list of objects is expected")
        found: list[JsonRecord] = []
        for index, item in enumerate(cast(list[Any], value)):
            place = f"{self._inside(name)}[{index}]"
            if not isinstance(item, dict):
                raise FileFormatError(
                    f"{place} is {_shown(item)}; an object is expected", path=self.path
                )
            found.append(JsonRecord(cast(dict[str, Any], item), place, self.path))
        return found

    def _inside(self, name: str) -> str:
        return f"{self.where}.{name}" if self.where else name


def _is_number(value: Any) -> bool:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return abs(value) < GREATEST and math.isfinite(value)


def _shown(value: Any) -> str:
    if value is None:
        return "missing"
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        items = cast(list[Any], value)
        return f"a list of {len(items)}"
    return str(value)[:40] if isinstance(value, (int, float, bool)) else repr(value[:40])
