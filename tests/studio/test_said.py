"""What a page says is read strictly: the kind, the range, and nothing guessed."""

from __future__ import annotations

from typing import Any

import pytest

from footfall.errors import ArgumentError
from footfall.studio.said import Said

FIELDS: dict[str, Any] = {
    "name": "walk",
    "empty": "",
    "two": 2,
    "half": 0.5,
    "not": float("nan"),
    "huge": float("inf"),
    "yes": True,
    "no": False,
    "list": [1],
}


def test_what_is_as_it_must_be_is_returned() -> None:
    said = Said(FIELDS)
    assert said.text("name") == "walk"
    assert said.number("half", 0.0, 1.0) == 0.5
    assert said.number("two", 2.0, 2.0) == 2.0
    assert said.count("two", 0, 5) == 2
    assert isinstance(said.count("two", 0, 5), int)
    assert said.flag("yes") is True
    assert said.flag("no") is False


@pytest.mark.parametrize(
    ("kind", "asked", "told"),
    [
        ("text", ("empty",), "empty is ''; a text is needed"),
        ("text", ("two",), "two is 2; a text is needed"),
        ("text", ("missing",), "missing is None; a text is needed"),
        ("number", ("two", 0, 1), "two is 2; a number from 0 to 1"),
        ("number", ("two", 3, 4), "two is 2; a number from 3 to 4"),
        ("number", ("yes", 0, 1), "yes is True; a number from 0 to 1"),
        ("number", ("not", 0, 1), "not is nan; a number from 0 to 1"),
        ("number", ("huge", 0, 1), "huge is inf; a number from 0 to 1"),
        ("number", ("name", 0, 1), "name is 'walk'; a number from 0 to 1"),
        ("number", ("missing", 0, 1), "missing is None; a number from 0 to 1"),
        ("count", ("half", 0, 1), "half is 0.5; a whole number from 0 to 1"),
        ("count", ("two", 0, 1), "two is 2; a number from 0 to 1"),
        ("flag", ("two",), "two is 2; true or false is needed"),
        ("flag", ("missing",), "missing is None; true or false is needed"),
        ("flag", ("list",), "list is [1]; true or false is needed"),
    ],
)
def test_what_is_not_is_told_whole(kind: str, asked: tuple[Any, ...], told: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        getattr(Said(FIELDS), kind)(*asked)
    assert str(caught.value) == told
