"""Corrections of a map, read from TOML."""

from __future__ import annotations

from pathlib import Path

import pytest

from footfall.errors import FileFormatError
from footfall.io.map_file import load_map


def test_a_joint_is_driven_by_one_or_two_or_rests(tmp_path: Path) -> None:
    path = tmp_path / "map.toml"
    path.write_text('[joints]\na = "x"\nb = ["x", "y", 0.25]\nc = "rest"\n')
    assert load_map(path) == {"a": ("x", "x", 0.0), "b": ("x", "y", 0.25), "c": None}


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("x = [", "cannot be read as TOML"),
        ("[bones]\n", "a map file has one table, [joints]; it has 'bones'"),
        ("", "a map file has one table, [joints]; it has none"),
        ("[joints]\na = 3\n", "'a' is 3; it must be a joint of the reference body"),
        ('[joints]\na = ["x", "y"]\n', "it must be a joint of the reference body"),
    ],
)
def test_anything_else_is_refused(tmp_path: Path, text: str, problem: str) -> None:
    path = tmp_path / "map.toml"
    path.write_text(text)
    with pytest.raises(FileFormatError) as caught:
        load_map(path)
    assert problem in str(caught.value)
    assert str(path) in str(caught.value)
