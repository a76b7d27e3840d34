from __future__ import annotations

from itertools import pairwise

import pytest

from footfall.errors import ArgumentError
from footfall.io.units import LONGEST_LEG, SHORTEST_LEG, UNITS, Unit, parse_unit, unit_of_leg


def test_no_length_fits_two_units() -> None:
    for longer, shorter in pairwise(UNITS):
        assert LONGEST_LEG / longer.metres < SHORTEST_LEG / shorter.metres


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("metres", [0.66, 0.8, 1.04])
def test_the_unit_of_a_persons_leg_is_found(unit: Unit, metres: float) -> None:
    assert unit_of_leg(metres / unit.metres) == unit


@pytest.mark.parametrize("length", [0.0, 0.5, 1.2, 50.0, 5000.0])
def test_a_leg_that_is_nobodys_has_no_unit(length: float) -> None:
    assert unit_of_leg(length) is None


@pytest.mark.parametrize("unit", UNITS)
def test_a_unit_is_found_by_its_name(unit: Unit) -> None:
    assert parse_unit(unit.name) is unit


def test_a_unit_may_be_a_number_of_metres() -> None:
    assert parse_unit(0.9144) == Unit("0.9144 m", 0.9144)


@pytest.mark.parametrize(
    ("unit", "message"),
    [
        ("ell", "unit 'ell' is unknown; use m, foot, dm, cmu, inch, cm, mm, or a number of metres"),
        (0.0, "a unit of 0.0 m is impossible; it must be longer than zero"),
        (-1.0, "a unit of -1.0 m is impossible; it must be longer than zero"),
        (float("nan"), "a unit of nan m is impossible; it must be longer than zero"),
    ],
)
def test_an_impossible_unit_is_refused(unit: str | float, message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        parse_unit(unit)
    assert str(caught.value) == message
