"""Annotate a whole archive: `annotate`."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeRemainingColumn,
)

from footfall.datasets import ClipAnnotation, annotate_archive, dask_executor, local_pool
from footfall.datasets.archive import PAGE, TABLE
from footfall.datasets.clip_annotation import Limits
from footfall.errors import FootfallError

__all__ = ["annotate"]


def annotate(
    folder: Path,
    /,
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))],
    workers: int | None = None,
    dask: str | None = None,
    height: float | None = None,
    speed: float | None = None,
) -> None:
    """Detect the supports of every motion below a folder, and measure how much its feet slip.

    Writes a .supports file a motion, one table (annotations.parquet), and one page
    (annotations.html) with the worst files on top. Run again, it goes on where it was.

    Parameters
    ----------
    folder
        The archive; searched through all its folders.
    output
        The folder to write to; made if it is missing.
    workers
        How many processes work; by default one a core.
    dask
        Work on the Dask cluster whose scheduler is at this address instead.
    height
        The paper's greatest height of the lowest point of a foot that carries [m].
    speed
        The paper's greatest speed of that point [m/s].
    """
    executors: Callable[[], Executor] = (
        partial(local_pool, workers) if dask is None else partial(dask_executor, dask)
    )
    limits = Limits(height, speed)
    with _progress() as progress:
        task = progress.add_task("", total=None, rate="", failed="")
        told = _Teller(progress, task)
        try:
            summary = annotate_archive(
                folder, output, limits=limits, executors=executors, told=told
            )
        except KeyboardInterrupt:
            raise FootfallError(
                f"interrupted after {told.done} of {told.total} files; run the same again to go on"
            ) from None
    print(f"{summary.files} files, {summary.kept} of them done before, {summary.failed} not usable")
    print(output / TABLE)
    print(output / PAGE)


def _progress() -> Progress:
    return Progress(
        BarColumn(bar_width=None),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
        TextColumn("{task.fields[failed]}"),
        console=Console(stderr=True),
    )


class _Teller:
    """Moves the progress bar: how many are done, how fast, and how many failed."""

    def __init__(self, progress: Progress, task: TaskID) -> None:
        self._progress, self._task = progress, task
        self._kept = self._failed = 0
        self.done = self.total = 0

    def __call__(self, done: int, total: int, row: ClipAnnotation | None) -> None:
        self.done, self.total = done, total
        if row is None:
            self._kept = done
        elif row.error is not None:
            self._failed += 1
        elapsed = self._progress.tasks[self._task].elapsed or 0.0
        rate = (done - self._kept) / elapsed if elapsed > 0.0 else 0.0
        self._progress.update(
            self._task,
            total=total,
            completed=done,
            rate=f"{rate:.0f} files/s",
            failed=f"{self._failed} not usable" if self._failed else "",
        )
