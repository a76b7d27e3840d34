from __future__ import annotations

import re
from pathlib import Path

import pytest

from footfall import errors
from footfall.errors import FileFormatError, FootfallError, UnknownNameError

ALL: list[type[Exception]] = [getattr(errors, name) for name in errors.__all__]


@pytest.mark.parametrize("error", ALL)
def test_every_error_is_one_of_ours(error: type[Exception]) -> None:
    assert issubclass(error, FootfallError)


@pytest.mark.parametrize("error", [error for error in ALL if error is not FootfallError])
def test_a_stranger_can_catch_every_error_by_the_builtin_in_the_drawn_tree(
    error: type[Exception],
) -> None:
    drawn = re.search(rf"── {error.__name__} .*\(also (\w+)\)$", errors.__doc__ or "", re.M)
    assert drawn is not None
    builtin = {
        "ValueError": ValueError,
        "LookupError": LookupError,
        "ImportError": ImportError,
        "RuntimeError": RuntimeError,
    }[drawn[1]]
    assert issubclass(error, builtin)


def test_no_error_is_left_out_of_the_module() -> None:
    defined = {
        name
        for name, value in vars(errors).items()
        if isinstance(value, type) and issubclass(value, Exception)
    }
    assert defined == set(errors.__all__)


def test_a_file_error_says_where_and_keeps_its_facts() -> None:
    error = FileFormatError("frame 37 has 95 values; 96 are needed", path="a/walk.bvh", line=412)
    assert str(error) == "a/walk.bvh:412: frame 37 has 95 values; 96 are needed"
    assert error.path == Path("a/walk.bvh")
    assert (error.line, error.problem) == (412, "frame 37 has 95 values; 96 are needed")


def test_an_error_of_a_whole_file_names_no_line() -> None:
    assert str(FileFormatError("it is empty", path=Path("walk.bvh"))) == "walk.bvh: it is empty"


@pytest.mark.parametrize(
    ("known", "message"),
    [
        (iter(["walk", "run"]), "no action named 'wlak'; there are: walk, run"),
        ([], "no action named 'wlak'; there are: none yet"),
    ],
)
def test_an_unknown_name_is_answered_with_those_there_are(known: list[str], message: str) -> None:
    error = UnknownNameError("action", "wlak", known)
    assert str(error) == message
    assert error.name == "wlak"
    assert isinstance(error.known, tuple)
