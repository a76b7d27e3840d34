"""One message of a page, its fields read strictly."""

from __future__ import annotations

import math
from typing import Any

from footfall.errors import ArgumentError

__all__ = ["Said"]


class Said:
    """The fields of one message."""

    def __init__(self, fields: dict[str, Any]) -> None:
        """Take a message."""
        self._fields = fields

    def text(self, key: str) -> str:
        """Return a text."""
        value = self._fields.get(key)
        if not isinstance(value, str) or not value:
            raise ArgumentError(f"{key} is {value!r}; a text is needed")
        return value

    def number(self, key: str, least: float, greatest: float) -> float:
        """Return a number."""
        value: object = self._fields.get(key)
        known = isinstance(value, int | float) and not isinstance(value, bool)
        number = float(value) if isinstance(value, int | float) else math.nan
        if not (known and least <= number <= greatest):
            raise ArgumentError(f"{key} is {value!r}; a number from {least:g} to {greatest:g}")
        return number

    def count(self, key: str, least: int, greatest: int) -> int:
        """Return a whole number."""
        number = self.number(key, least, greatest)
        if not number.is_integer():
            raise ArgumentError(f"{key} is {number}; a whole number from {least} to {greatest}")
        return int(number)

    def flag(self, key: str) -> bool:
        """Return true or false."""
        value = self._fields.get(key)
        if not isinstance(value, bool):
            raise ArgumentError(f"{key} is {value!r}; true or false is needed")
        return value
