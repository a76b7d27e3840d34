from __future__ import annotations

from pathlib import Path

import pytest

from footfall.errors import FileFormatError
from footfall.io import atomic as module
from footfall.io import write_atomically


def test_a_file_is_written_whole_and_nothing_else_is_left(tmp_path: Path) -> None:
    path = tmp_path / "walk.bvh"
    write_atomically(path, b"one")
    write_atomically(path, b"another")
    assert path.read_bytes() == b"another"
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "walk.bvh"
    with pytest.raises(FileFormatError) as caught:
        write_atomically(path, b"")
    assert str(caught.value) == (
        f"{path}: cannot be written: there is no folder {str(path.parent)!r}; make it first"
    )


def test_a_folder_is_not_overwritten(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        write_atomically(tmp_path, b"")
    assert str(caught.value) == f"{tmp_path}: cannot be written: it is a folder; name a file"


def test_a_failure_leaves_the_old_file_and_no_temporary_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "walk.bvh"
    path.write_bytes(b"old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(module.os, "fsync", full)
    with pytest.raises(FileFormatError) as caught:
        write_atomically(path, b"new")
    assert str(caught.value) == (
        f"{path}: cannot be written: no space left on device; choose a place that can be written to"
    )
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
