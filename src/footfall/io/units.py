"""Units of length that motion files are in, and which of them makes a leg a person's."""

from __future__ import annotations

import math
from dataclasses import dataclass

from footfall.errors import ArgumentError

__all__ = ["UNITS", "Unit", "parse_unit", "unit_of_leg"]

SHORTEST_LEG = 0.65
"""Thigh and shank of the smallest grown person that is looked for [m]."""

LONGEST_LEG = 1.05
"""Thigh and shank of the tallest one [m]. The longest is 1.62 times the shortest, and each unit
at least 1.77 times the next smaller one: no length fits two units."""


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit of length."""

    name: str
    """What it is called, in files and in `unit=`."""

    metres: float
    """How long it is [m]."""


UNITS = (
    Unit("m", 1.0),
    Unit("foot", 0.3048),
    Unit("dm", 0.1),
    Unit("cmu", 0.0254 / 0.45),
    Unit("inch", 0.0254),
    Unit("cm", 0.01),
    Unit("mm", 0.001),
)
"""The units that are looked for; ``cmu`` is 1/0.45 inch, which CMU's own files are in."""


def parse_unit(unit: str | float) -> Unit:
    """Return the unit with this name, or of this many metres.

    Raises:
        ArgumentError: If there is none.
    """
    if isinstance(unit, str):
        for known in UNITS:
            if known.name == unit:
                return known
        names = ", ".join(known.name for known in UNITS)
        raise ArgumentError(f"unit {unit!r} is unknown; use {names}, or a number of metres")
    if not (math.isfinite(unit) and 1e-9 < unit < 1e9):
        raise ArgumentError(f"a unit of {unit} m is impossible; it must be longer than zero")
    return Unit(f"{unit:g} m", float(unit))


def unit_of_leg(length: float) -> Unit | None:
    """Return the unit in which a leg of this length is a person's, or None."""
    for unit in UNITS:
        if SHORTEST_LEG <= length * unit.metres <= LONGEST_LEG:
            return unit
    return None
