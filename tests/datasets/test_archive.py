from __future__ import annotations

import os
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import pytest
from tests.datasets.archives import BROKEN, FILES, make_archive

from footfall.datasets import ArchiveSummary, ClipAnnotation, annotate_archive, local_pool
from footfall.datasets.archive import PAGE, TABLE, motion_files
from footfall.datasets.manifest import MANIFEST
from footfall.detection import detect_supports
from footfall.errors import ArgumentError, FileFormatError
from footfall.io import load, load_supports
from footfall.io.table_files import read_parquet

pytest.importorskip("pyarrow")

threads = partial(ThreadPoolExecutor, 2)


class Told:
    """Keeps what it is told; interrupts after so many files."""

    def __init__(self, stop_after: int | None = None) -> None:
        self.rows: list[ClipAnnotation] = []
        self.kept = self.total = 0
        self._stop_after = stop_after

    def __call__(self, done: int, total: int, row: ClipAnnotation | None) -> None:
        self.total = total
        if row is None:
            self.kept = done
            return
        self.rows.append(row)
        assert done == self.kept + len(self.rows)
        if len(self.rows) == self._stop_after:
            raise KeyboardInterrupt

    @property
    def files(self) -> list[str]:
        return sorted(row.file for row in self.rows)


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_processes_write_what_threads_write(tmp_path: Path) -> None:
    archive = make_archive(tmp_path / "archive", broken=True)
    summary = annotate_archive(archive, tmp_path / "one", executors=partial(local_pool, 2))
    annotate_archive(archive, tmp_path / "other", executors=threads)
    assert summary == ArchiveSummary(files=7, kept=0, failed=1)
    assert contents(tmp_path / "one") == contents(tmp_path / "other")


def test_every_motion_gets_its_supports_a_row_and_a_line_of_the_page(tmp_path: Path) -> None:
    archive, out = make_archive(tmp_path / "archive", broken=True), tmp_path / "out"
    annotate_archive(archive, out, executors=threads)
    expected = {*(f"{file}.supports" for file in FILES), TABLE, PAGE, MANIFEST}
    assert set(contents(out)) == expected
    for file in FILES:
        supports = detect_supports(load(archive / file))
        assert str(load_supports(out / f"{file}.supports")) == str(supports)
    table = read_parquet(out / TABLE)
    assert tuple(table) == ClipAnnotation.columns()
    assert table["file"] == sorted([*FILES, BROKEN])
    page = (out / PAGE).read_text()
    assert all(file in page for file in [*FILES, BROKEN])


def test_a_second_run_does_only_what_changed_failed_or_was_lost(tmp_path: Path) -> None:
    archive, out = make_archive(tmp_path / "archive", broken=True), tmp_path / "out"
    annotate_archive(archive, out, executors=threads)
    first = contents(out)
    os.utime(archive / FILES[0], ns=(1, 1))
    (out / f"{FILES[1]}.supports").unlink()
    (archive / FILES[2]).unlink()
    told = Told()
    summary = annotate_archive(archive, out, executors=threads, told=told)
    assert told.files == sorted([BROKEN, FILES[0], FILES[1]])
    assert (told.kept, told.total, summary.kept) == (3, 6, 3)
    assert contents(out)[f"{FILES[1]}.supports"] == first[f"{FILES[1]}.supports"]
    assert FILES[2] not in (out / MANIFEST).read_text()


@pytest.mark.parametrize("stop_after", [1, 3, 5])
def test_an_interrupted_run_goes_on_where_it_was(tmp_path: Path, stop_after: int) -> None:
    archive, out = make_archive(tmp_path / "archive"), tmp_path / "out"
    before, after = Told(stop_after), Told()
    with pytest.raises(KeyboardInterrupt):
        annotate_archive(archive, out, executors=threads, told=before)
    annotate_archive(archive, out, executors=threads, told=after)
    # Nothing lost, nothing twice.
    assert Counter(before.files + after.files) == Counter(FILES)
    assert after.kept == stop_after
    annotate_archive(archive, tmp_path / "whole", executors=threads)
    assert contents(out) == contents(tmp_path / "whole")


def test_the_results_are_no_part_of_the_archive(tmp_path: Path) -> None:
    archive = make_archive(tmp_path / "archive")
    out = archive / "out"
    out.mkdir()
    (out / "copy.bvh").write_text("")
    assert motion_files(archive, out) == FILES


def test_a_folder_without_motions_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(ArgumentError, match=r"empty holds no motion; looked for \.bvh"):
        annotate_archive(tmp_path / "empty", tmp_path / "out")
    with pytest.raises(ArgumentError) as caught:
        annotate_archive(tmp_path / "none", tmp_path / "out")
    assert str(caught.value) == f"{tmp_path / 'none'} is no folder; name the folder of an archive"
    assert not (tmp_path / "out").exists()


def test_results_cannot_be_written_into_a_file(tmp_path: Path) -> None:
    archive = make_archive(tmp_path / "archive")
    (tmp_path / "out").write_text("mine")
    with pytest.raises(FileFormatError) as caught:
        annotate_archive(archive, tmp_path / "out", executors=threads)
    assert str(caught.value) == f"{tmp_path / 'out'}: cannot be made a folder: file exists"
    assert (tmp_path / "out").read_text() == "mine"
