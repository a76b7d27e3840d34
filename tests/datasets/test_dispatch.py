from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ThreadPoolExecutor
from functools import partial
from typing import Any

import pytest

from footfall.datasets import ClipAnnotation, local_pool
from footfall.datasets.dispatch import completed
from footfall.errors import FootfallError

FILES = tuple(f"{index:03d}.bvh" for index in range(150))


def annotated(file: str) -> ClipAnnotation:
    return ClipAnnotation(file, len(file), 0)


def deadly(file: str) -> ClipAnnotation:
    """Kill the process at one file, as a parser that crashes would."""
    if file == "077.bvh":
        os._exit(9)
    return annotated(file)


class Fails(Executor):
    """Answers every file with an error."""

    def __init__(self, error: BaseException) -> None:
        self._error = error

    def submit(self, _fn: Callable[..., Any], /, *_args: Any, **_known: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(self._error)
        return future


class Closed(Executor):
    def submit(self, _fn: Callable[..., Any], /, *_args: Any, **_known: Any) -> Future[Any]:
        raise RuntimeError("cannot schedule new futures after shutdown")


def test_every_file_comes_back_once() -> None:
    rows = list(completed(partial(ThreadPoolExecutor, 4), annotated, FILES))
    assert Counter(row.file for row in rows) == Counter(FILES)


def test_nothing_to_do_needs_no_workers() -> None:
    def none() -> Executor:
        raise AssertionError

    assert list(completed(none, annotated, [])) == []


def test_a_file_that_kills_its_worker_is_told_and_all_others_are_done() -> None:
    rows = list(completed(partial(local_pool, 2), deadly, FILES))
    assert Counter(row.file for row in rows) == Counter(FILES)
    failed = [row for row in rows if row.error is not None]
    assert [(row.file, row.error) for row in failed] == [
        ("077.bvh", "ended the process that worked on it")
    ]


def test_what_a_cluster_says_of_a_file_is_its_row() -> None:
    rows = list(completed(lambda: Fails(ValueError("killed\nworker")), annotated, FILES[:3]))
    assert {row.error for row in rows} == {"could not be worked on: ValueError: killed worker"}
    assert len(rows) == 3


@pytest.mark.parametrize(
    ("executor", "told"),
    [
        (Fails(CancelledError()), "their work was canceled"),
        (Closed(), "cannot schedule new futures after shutdown"),
    ],
)
def test_workers_that_are_gone_for_good_end_the_run(executor: Executor, told: str) -> None:
    with pytest.raises(FootfallError) as caught:
        list(completed(lambda: executor, annotated, FILES))
    assert str(caught.value) == (
        f"the workers went away: {told}; what is done is kept: run the same again to go on"
    )


def test_executors_that_only_break_are_not_made_for_ever() -> None:
    made: list[Executor] = []

    def breaking() -> Executor:
        made.append(Fails(BrokenExecutor()))
        return made[-1]

    with pytest.raises(FootfallError, match=r"6 of them ended in a row, without any result"):
        list(completed(breaking, annotated, FILES))
    assert len(made) == 6
