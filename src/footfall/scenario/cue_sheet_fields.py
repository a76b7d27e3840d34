"""The keys of a cue sheet's tables, read strictly: a message names the key and its range."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, cast

from footfall.engine.library import parse_priority
from footfall.errors import FootfallError, ScenarioError

__all__ = ["Fields"]


class Fields:
    """A table of a TOML file, and where in it the table stands."""

    def __init__(self, table: Mapping[str, Any], where: str) -> None:
        """Take a table.

        Args:
            table: Its keys and values.
            where: Its name in messages, such as ``action[0]``; empty for the whole file.
        """
        self._table = table
        self.where = where

    @property
    def names(self) -> tuple[str, ...]:
        """All keys, in the order of the file."""
        return tuple(self._table)

    def has(self, key: str) -> bool:
        """Whether a key is there."""
        return key in self._table

    def label(self, key: str) -> str:
        """Return the name of a key in messages."""
        return f"{self.where}.{key}" if self.where else key

    def know(self, *known: str) -> None:
        """Refuse keys other than these.

        Raises:
            ScenarioError: If there is one.
        """
        for key in self._table:
            if key not in known:
                place = f" in {self.where}" if self.where else ""
                raise ScenarioError(f"no key named {key!r}{place}; there are: {', '.join(known)}")

    def number(
        self, key: str, *, least: float, most: float, default: float | None, above: bool = False
    ) -> float:
        """Return a number.

        Args:
            key: Its key.
            least: The least it may be.
            most: The greatest.
            default: What it is if it is missing; None: it must not be.
            above: Whether it must be greater than `least`.

        Raises:
            ScenarioError: If it is none, out of range, or missing.
        """
        value: Any = self._table.get(key, default)
        ranged = f"above {least:g} and at most {most:g}" if above else f"{least:g} to {most:g}"
        if value is None:
            raise ScenarioError(f"{self.label(key)} is missing; give a number, {ranged}")
        fits = _is_number(value) and least <= value <= most and not (above and value == least)
        if not fits:
            raise ScenarioError(f"{self.label(key)} is {value!r}; it must be a number, {ranged}")
        return float(value)

    def text(self, key: str, default: str | None) -> str | None:
        """Return a text that is not empty.

        Raises:
            ScenarioError: If it is none.
        """
        value: Any = self._table.get(key, default)
        if value is not None and (not isinstance(value, str) or not value):
            raise ScenarioError(f"{self.label(key)} is {value!r}; it must be a text, not empty")
        return value

    def needed_text(self, key: str, what: str) -> str:
        """Return a text that must be there.

        Raises:
            ScenarioError: If it is none, or missing.
        """
        value = self.text(key, None)
        if value is None:
            raise ScenarioError(f"{self.label(key)} is missing; give {what}")
        return value

    def maybe_number(self, key: str, *, least: float, most: float) -> float | None:
        """Return a number as of `number`; None where it is missing."""
        return self.number(key, least=least, most=most, default=None) if self.has(key) else None

    def texts(self, key: str, what: str) -> list[str]:
        """Return at least one text, none of them empty.

        Raises:
            ScenarioError: If they are not.
        """
        value: Any = self._table.get(key)
        items = cast(list[Any], value) if isinstance(value, list) else []
        if not items or not all(isinstance(item, str) and item for item in items):
            raise ScenarioError(f"{self.label(key)} is {value!r}; it must be a list, each {what}")
        return items

    def flag(self, key: str, default: bool | None) -> bool | None:
        """Return true or false.

        Raises:
            ScenarioError: If it is neither.
        """
        value: Any = self._table.get(key, default)
        if value is not None and not isinstance(value, bool):
            raise ScenarioError(f"{self.label(key)} is {value!r}; it must be true or false")
        return value

    def choice(self, key: str, choices: tuple[str, ...]) -> str:
        """Return one of some words; the first of them where it is missing.

        Raises:
            ScenarioError: If it is none of them.
        """
        value: Any = self._table.get(key, choices[0] if choices else None)
        if not isinstance(value, str) or value not in choices:
            raise ScenarioError(f"{self.label(key)} is {value!r}; there are: {', '.join(choices)}")
        return value

    def one_of(self, key: str, known: list[str]) -> str:
        """Return a key that must be one of some names.

        Raises:
            ScenarioError: If it is none of them.
        """
        if key not in known:
            raise ScenarioError(f"{self.where} names {key!r}; there are: {', '.join(known)}")
        return key

    def priority(self, key: str, default: float) -> float | Mapping[str, float]:
        """Return a priority: one number, or a table of numbers by body part.

        Raises:
            ScenarioError: If it is neither, negative, all zero, or a body part is unknown.
        """
        value: Any = self._table.get(key, default)
        numbers = cast(dict[str, Any], value if isinstance(value, dict) else {"": value})
        if not numbers or not all(_is_number(number) for number in numbers.values()):
            raise ScenarioError(
                f"{self.label(key)} is {value!r}; it must be a number, or a table of numbers by "
                "body part such as { legs = 1.0, arms = 0.2 }"
            )
        try:
            parse_priority(cast("float | Mapping[str, float]", value))
        except FootfallError as error:
            raise ScenarioError(f"{self.label(key)}: {error}") from error
        return cast("float | Mapping[str, float]", value)

    def stretch(self, key: str) -> tuple[float, float] | None:
        """Return two times [s], the second after the first; None where they are missing.

        Raises:
            ScenarioError: If they are not.
        """
        value: Any = self._table.get(key)
        if value is None:
            return None
        times = cast(list[Any], value) if isinstance(value, list) else []
        if len(times) != 2 or not all(map(_is_number, times)) or not 0 <= times[0] < times[1]:
            raise ScenarioError(
                f"{self.label(key)} is {value!r}; it must be two times in seconds, "
                "such as [0.5, 1.8]"
            )
        return float(times[0]), float(times[1])

    def pair(self, key: str, *, most: float) -> tuple[float, float]:
        """Return two numbers, each from -`most` to `most`; zeros where they are missing.

        Raises:
            ScenarioError: If they are not.
        """
        value: Any = self._table.get(key, [0.0, 0.0])
        numbers = cast(list[Any], value) if isinstance(value, list) else []
        if len(numbers) != 2 or not all(_is_number(one) and abs(one) <= most for one in numbers):
            raise ScenarioError(
                f"{self.label(key)} is {value!r}; it must be two numbers from {-most:g} to {most:g}"
            )
        return float(numbers[0]), float(numbers[1])

    def triple(self, key: str, *, most: float) -> tuple[float, float, float]:
        """Return three numbers, each from -`most` to `most`.

        Raises:
            ScenarioError: If they are not, or missing.
        """
        value: Any = self._table.get(key)
        numbers = cast(list[Any], value) if isinstance(value, list) else []
        if len(numbers) != 3 or not all(_is_number(one) and abs(one) <= most for one in numbers):
            found = "missing" if value is None else repr(cast(object, value))
            raise ScenarioError(
                f"{self.label(key)} is {found}; it must be three numbers from {-most:g} to {most:g}"
            )
        return float(numbers[0]), float(numbers[1]), float(numbers[2])

    def is_table(self, key: str) -> bool:
        """Whether a key has a table of its own."""
        return isinstance(self._table.get(key), dict)

    def table(self, key: str) -> Fields:
        """Return a table with at least one key.

        Raises:
            ScenarioError: If it is none.
        """
        value: Any = self._table.get(key)
        if not isinstance(value, dict) or not value:
            raise ScenarioError(
                f"{self.label(key)} is {value!r}; it must be a table such as {{ walk = 2.0 }}"
            )
        return Fields(cast(dict[str, Any], value), self.label(key))

    def tables(self, key: str) -> list[Fields]:
        """Return an array of tables with at least one entry.

        Raises:
            ScenarioError: If it is none, or missing.
        """
        value: Any = self._table.get(key)
        entries = cast(list[Any], value) if isinstance(value, list) else []
        if not entries or not all(isinstance(entry, dict) for entry in entries):
            raise ScenarioError(f"there is no [[{key}]]; at least one is needed")
        return [Fields(entry, f"{key}[{index}]") for index, entry in enumerate(entries)]


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
