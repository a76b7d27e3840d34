from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from footfall.errors import FileFormatError
from footfall.io.json_record import JsonRecord, parse_json

FILE = Path("a.json")

SOUND = parse_json(
    b'\xef\xbb\xbf{"n": 3, "r": 2.0, "x": -1.5, "t": "hip", "f": true, "i": [0, 2], "v": [1, 2.5],'
    b' "o": {"n": 1}, "l": [{"n": 4}, {"n": 5}], "none": null}',
    FILE,
)


def test_every_kind_is_read() -> None:
    assert (SOUND.integer("n"), SOUND.integer("r"), SOUND.number("x")) == (3, 2, -1.5)
    assert (SOUND.text("t"), SOUND.flag("f"), SOUND.indices("i", 3)) == ("hip", True, [0, 2])
    assert SOUND.numbers("v", 2).tolist() == [1.0, 2.5]
    inner = SOUND.record("o")
    assert inner is not None
    assert (inner.integer("n"), inner.where) == (1, "o")
    assert [(one.integer("n"), one.where) for one in SOUND.records("l")] == [
        (4, "l[0]"),
        (5, "l[1]"),
    ]


@pytest.mark.parametrize("name", ["none", "missing"])
def test_what_is_missing_or_null_has_its_default(name: str) -> None:
    assert not SOUND.has(name)
    assert (SOUND.integer(name, 7), SOUND.number(name, 0.5), SOUND.text(name, "")) == (7, 0.5, "")
    assert SOUND.numbers(name, 2, (1.0, 2.0)).tolist() == [1.0, 2.0]
    assert (SOUND.indices(name, 3), SOUND.records(name), SOUND.record(name)) == ([], [], None)
    assert not SOUND.flag("missing")


INSIDE = JsonRecord(
    {
        "b": True,
        "h": 1.5,
        "big": 1e13,
        "t": 3,
        "o": [],
        "l": {},
        "m": [1],
        "i": [3],
        "v": [1, None],
    },
    "nodes[3]",
    FILE,
)

WRONG: tuple[tuple[Callable[[JsonRecord], Any], str], ...] = (
    (
        lambda record: record.integer("x", below=9),
        "x is missing; a whole number within 0..8 is expected",
    ),
    (
        lambda record: record.integer("b", below=9),
        "b is True; a whole number within 0..8 is expected",
    ),
    (
        lambda record: record.integer("h", below=9),
        "h is 1.5; a whole number within 0..8 is expected",
    ),
    (
        lambda record: record.integer("t", least=4, below=9),
        "t is 3; a whole number within 4..8 is expected",
    ),
    (
        lambda record: record.number("big"),
        "big is 10000000000000.0; a finite number below 1e12 is expected",
    ),
    (lambda record: record.number("b"), "b is True; a finite number below 1e12 is expected"),
    (
        lambda record: record.numbers("v", 2),
        "v is a list of 2; 2 finite numbers below 1e12 are expected",
    ),
    (lambda record: record.numbers("t", 2), "t is 3; 2 numbers are expected"),
    (lambda record: record.text("t"), "t is 3; a text is expected"),
    (lambda record: record.flag("t"), "t is 3; true or false is expected"),
    (
        lambda record: record.indices("i", 3),
        "i is a list of 1; whole numbers below 3 are expected",
    ),
    (lambda record: record.record("o"), "o is a list of 0; an object is expected"),
    (lambda record: record.records("l"), "l is an object; a list of objects is expected"),
    (lambda record: record.records("m"), "m[0] is 1; an object is expected"),
)


@pytest.mark.parametrize(("ask", "message"), WRONG, ids=[message for _, message in WRONG])
def test_another_kind_is_refused_with_its_place(
    ask: Callable[[JsonRecord], Any], message: str
) -> None:
    with pytest.raises(FileFormatError) as refusal:
        ask(INSIDE)
    assert str(refusal.value) == f"a.json: nodes[3].{message}"


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"[1]", "is JSON, but no object; one is expected, {...}"),
        (b'{"a": NaN}', "is no JSON: NaN is no number of JSON"),
        (b"\xff", "is no JSON: 'utf-8' codec can't decode byte 0xff"),
        (b"[" * 100_000, "is no JSON: maximum recursion depth exceeded"),
    ],
)
def test_what_is_no_object_of_json_is_refused(data: bytes, message: str) -> None:
    with pytest.raises(FileFormatError) as refusal:
        parse_json(data, FILE)
    assert str(refusal.value).startswith(f"a.json: {message}")
