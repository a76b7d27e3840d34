"""An archive annotated: every motion's supports, one table, and one page with the worst on top."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from footfall.datasets.clip_annotation import ClipAnnotation, Limits, annotate_clip
from footfall.datasets.dispatch import completed
from footfall.datasets.executors import local_pool
from footfall.datasets.manifest import Manifest
from footfall.datasets.page import summary_page
from footfall.datasets.table import write_table
from footfall.errors import ArgumentError, FileFormatError
from footfall.extras import extra_module
from footfall.io import write_atomically
from footfall.io.motion_formats import READERS

__all__ = ["PAGE", "TABLE", "ArchiveSummary", "annotate_archive", "motion_files"]

TABLE, PAGE = "annotations.parquet", "annotations.html"
"""The names of the table and the page in the folder of the results."""

Told = Callable[[int, int, ClipAnnotation | None], None]
"""Is told how many files are done, of how many, and the row of the last one; None at the start."""

SUFFIXES = tuple(sorted(suffix for suffix in READERS if not suffix.startswith(".txt")))
"""Of the files of an archive that are motions: most of its plain texts are none."""


@dataclass(frozen=True, slots=True)
class ArchiveSummary:
    """What became of an archive."""

    files: int
    """How many motions it holds."""

    kept: int
    """How many of them an earlier run had done."""

    failed: int
    """How many could not be used."""


def motion_files(archive: Path, output: Path) -> tuple[str, ...]:
    """Return the motions of an archive, by their paths in it, in order.

    Args:
        archive: The folder.
        output: The folder of the results, which is left out where it lies within.

    Raises:
        ArgumentError: If there is no such folder, or it holds no motion.
    """
    if not archive.is_dir():
        raise ArgumentError(f"{archive} is no folder; name the folder of an archive")
    results = output.resolve()
    files = [
        path.relative_to(archive).as_posix()
        for path in archive.rglob("*")
        if path.name.lower().endswith(SUFFIXES)
        and path.is_file()
        and results not in path.resolve().parents
    ]
    if not files:
        raise ArgumentError(f"{archive} holds no motion; looked for {', '.join(SUFFIXES)}")
    return tuple(sorted(files))


def annotate_archive(
    archive: Path,
    output: Path,
    *,
    limits: Limits | None = None,
    executors: Callable[[], Executor] = local_pool,
    told: Told | None = None,
) -> ArchiveSummary:
    """Detect the supports of every motion of an archive, and measure its slip in them.

    Beside the table and the page, ``walk.bvh`` gives ``walk.bvh.supports``, in the same place under
    `output`. A file that cannot be used is told in its row, and stops nothing. A run that was
    broken off goes on where it was: a file is done again only if it changed, failed, or lost its
    supports.

    Args:
        archive: The folder; searched through all its folders.
        output: The folder to write to; made if it is missing.
        limits: The detector's.
        executors: Makes what does the work: see `local_pool` and `dask_executor`. It is called
            again where an executor breaks.
        told: Is told how it goes on.

    Raises:
        ArgumentError: If there is no motion to annotate.
        FileFormatError: If `output` holds other results, or cannot be written to.
        MissingExtraError: If PyArrow is not installed.
        FootfallError: If the workers went away for good.
    """
    extra_module("pyarrow", "writing the table of an archive", extra="tables")
    limits = Limits() if limits is None else limits
    files = motion_files(archive, output)
    _make_folder(output)
    with Manifest(output, limits) as manifest:
        manifest.keep_only(set(files))
        waiting = [file for file in files if not _done(manifest.row(file), archive, output)]
        kept = len(files) - len(waiting)
        if told is not None:
            told(kept, len(files), None)
        task = partial(annotate_clip, str(archive), limits=limits)
        for count, row in enumerate(completed(executors, task, waiting), start=kept + 1):
            _store(row, output, manifest)
            if told is not None:
                told(count, len(files), row)
        rows = manifest.rows
    write_table(rows, output / TABLE)
    write_atomically(output / PAGE, summary_page(rows, archive.name or str(archive)).encode())
    return ArchiveSummary(len(files), kept, sum(row.error is not None for row in rows))


def _done(row: ClipAnnotation | None, archive: Path, output: Path) -> bool:
    if row is None or row.error is not None or not _supports_file(row.file, output).exists():
        return False
    try:
        facts = (archive / row.file).stat()
    except OSError:
        return False
    return (facts.st_size, facts.st_mtime_ns) == (row.size, row.changed)


def _store(row: ClipAnnotation, output: Path, manifest: Manifest) -> None:
    """Write the supports, and only then that the file is done."""
    if row.labels is not None:
        path = _supports_file(row.file, output)
        _make_folder(path.parent)
        write_atomically(path, row.labels.encode())
    manifest.add(row)


def _supports_file(file: str, output: Path) -> Path:
    return output / f"{file}.supports"


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileFormatError(f"cannot be made a folder: {reason}", path=folder) from error
