"""Nothing is ever written outside of the folder the studio was started in."""

from __future__ import annotations

from pathlib import Path

import pytest

from footfall.errors import FileFormatError
from footfall.studio import work_folder
from footfall.studio.work_folder import WorkFolder


@pytest.fixture
def folder(tmp_path: Path) -> WorkFolder:
    (tmp_path / "work").mkdir()
    (tmp_path / "other").mkdir()
    return WorkFolder.at(tmp_path / "work")


def test_a_file_in_the_folder_is_written(folder: WorkFolder) -> None:
    assert folder.write("a.supports", b"once\n").read_bytes() == b"once\n"


@pytest.mark.parametrize("name", ["../other/a.bvh", "/tmp/a.bvh", "..", ".", "x/../../a.bvh"])
def test_a_place_outside_is_refused(folder: WorkFolder, name: str) -> None:
    with pytest.raises(FileFormatError, match=r"lies outside of|is no name"):
        folder.write(name, b"")
    assert list((folder.root.parent / "other").iterdir()) == []


def test_a_linked_folder_leads_nowhere(folder: WorkFolder) -> None:
    (folder.root / "link").symlink_to(folder.root.parent / "other")
    with pytest.raises(FileFormatError, match="lies outside of"):
        folder.write("link/a.bvh", b"")
    assert list((folder.root.parent / "other").iterdir()) == []


def test_a_link_is_never_written_through(folder: WorkFolder) -> None:
    target = folder.root.parent / "other" / "a.bvh"
    target.write_bytes(b"mine")
    (folder.root / "a.bvh").symlink_to(target)
    with pytest.raises(FileFormatError, match="is a link"):
        folder.write("a.bvh", b"yours")
    assert target.read_bytes() == b"mine"


def test_a_huge_file_is_refused_before_it_is_read(
    folder: WorkFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(work_folder, "LARGEST_FILE", 10)
    (folder.root / "a.bvh").write_bytes(b"x" * 11)
    with pytest.raises(FileFormatError, match=r"is 0 MiB; the studio reads files up to 0 MiB"):
        folder.readable("a.bvh")


def test_motions_are_listed_without_hidden_and_linked_ones(folder: WorkFolder) -> None:
    for name in ("b.bvh", "a.npz", ".c.bvh", "sheet.toml"):
        (folder.root / name).write_bytes(b"")
    (folder.root / "deep").mkdir()
    (folder.root / "deep" / "d.bvh.gz").write_bytes(b"")
    (folder.root / "link.bvh").symlink_to(folder.root / "b.bvh")
    assert folder.motions() == ["a.npz", "b.bvh", "deep/d.bvh.gz"]
    assert folder.scenarios() == ["sheet.toml"]
