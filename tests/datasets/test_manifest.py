from __future__ import annotations

import json
from pathlib import Path

import pytest

from footfall.datasets import ClipAnnotation, Manifest
from footfall.datasets.clip_annotation import Limits
from footfall.datasets.manifest import MANIFEST
from footfall.errors import FileFormatError

ROWS = (ClipAnnotation("b.bvh", 10, 20, frames=3), ClipAnnotation("a.bvh", 1, 2, error="é"))


def filled(folder: Path) -> Path:
    with Manifest(folder, Limits()) as manifest:
        for row in ROWS:
            manifest.add(row)
    return folder / MANIFEST


def test_rows_are_found_again_in_order(tmp_path: Path) -> None:
    filled(tmp_path)
    with Manifest(tmp_path, Limits()) as manifest:
        assert manifest.rows == (ROWS[1], ROWS[0])
        assert manifest.row("b.bvh") == ROWS[0]
        assert manifest.row("c.bvh") is None


def test_a_row_is_on_the_disk_as_soon_as_it_is_added(tmp_path: Path) -> None:
    with Manifest(tmp_path, Limits()) as manifest:
        manifest.add(ROWS[0])
        lines = (tmp_path / MANIFEST).read_text().splitlines()
        assert [json.loads(line).get("file") for line in lines] == [None, "b.bvh"]


@pytest.mark.parametrize("cut", [1, 2, 30, 200])
def test_a_line_that_was_cut_short_loses_its_file_only(tmp_path: Path, cut: int) -> None:
    path = filled(tmp_path)
    path.write_bytes(path.read_bytes()[:-cut])
    with Manifest(tmp_path, Limits()) as manifest:
        # The newline alone is no loss.
        assert [row.file for row in manifest.rows] == (
            ["a.bvh", "b.bvh"] if cut == 1 else ["a.bvh"]
        )
        manifest.add(ROWS[0])
    with Manifest(tmp_path, Limits()) as manifest:
        assert manifest.rows == (ROWS[1], ROWS[0])


def test_files_that_are_gone_are_forgotten(tmp_path: Path) -> None:
    filled(tmp_path)
    with Manifest(tmp_path, Limits()) as manifest:
        manifest.keep_only({"a.bvh"})
    assert "b.bvh" not in (tmp_path / MANIFEST).read_text()


def test_other_limits_are_not_mixed_in(tmp_path: Path) -> None:
    path = filled(tmp_path)
    with pytest.raises(FileFormatError) as caught:
        Manifest(tmp_path, Limits(height=0.05))
    assert str(caught.value) == (
        f"{path}: was made with height=None and speed=None; go on with these, or use another folder"
    )


@pytest.mark.parametrize("content", ["", "{}", "[1]", '{"format": "footfall annotations"}'])
def test_a_manifest_of_somebody_else_is_left_alone(tmp_path: Path, content: str) -> None:
    (tmp_path / MANIFEST).write_text(content)
    with pytest.raises(FileFormatError) as caught:
        Manifest(tmp_path, Limits())
    assert str(caught.value) == (
        f"{tmp_path / MANIFEST}: is no manifest of version 1; use another folder"
    )
    assert (tmp_path / MANIFEST).read_text() == content


def test_lines_that_are_no_rows_are_dropped(tmp_path: Path) -> None:
    path = filled(tmp_path)
    path.write_text(path.read_text() + '{"file": 3}\n[]\n{"what": 1}\n')
    with Manifest(tmp_path, Limits()) as manifest:
        assert len(manifest.rows) == 2
