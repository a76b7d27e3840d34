"""Files handed to an executor, and rows back, whatever becomes of its workers."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    wait,
)

from footfall.datasets.clip_annotation import ClipAnnotation
from footfall.errors import FootfallError

__all__ = ["completed"]

IN_HAND = 64
"""How many files are handed out at a time: enough to keep the workers busy, and few to do again."""

MOST_BROKEN = 5
"""How many executors may break one after the other before it is given up: then it is not the files
(such as in a program that starts workers without ``if __name__ == "__main__"``)."""

Task = Callable[[str], ClipAnnotation]


def completed(
    executors: Callable[[], Executor], task: Task, files: Iterable[str]
) -> Iterator[ClipAnnotation]:
    """Yield the row of every file once, in the order in which they are done.

    Where a worker dies, an executor such as Dask's gives its files to others. A pool of processes
    instead breaks as a whole: then a new one is made, and the files that were in hand are tried one
    at a time, so that the file which kills its worker is known, told in its row, and left behind.

    Args:
        executors: Makes an executor; called again after one broke.
        task: What is done with a file; must be picklable.
        files: The files.

    Raises:
        FootfallError: If the workers went away for good.
    """
    waiting, suspects = deque(files), deque[str]()
    broken_in_a_row = 0
    while waiting or suspects:
        executor = executors()
        try:
            for queue, in_hand in ((suspects, 1), (waiting, IN_HAND)):
                for row in _drained(executor, task, queue, in_hand=in_hand):
                    broken_in_a_row = 0
                    yield row
        except _BrokenError as broken:
            broken_in_a_row += 1
            if broken_in_a_row > MOST_BROKEN:
                raise _gone(
                    f"{broken_in_a_row} of them ended in a row, without any result"
                ) from None
            if len(broken.files) > 1:
                suspects.extend(broken.files)
            else:
                told = "ended the process that worked on it"
                yield ClipAnnotation(broken.files[0], 0, 0, error=told)
        finally:
            executor.shutdown(wait=False, cancel_futures=True)


def _gone(reason: str) -> FootfallError:
    return FootfallError(
        f"the workers went away: {reason}; what is done is kept: run the same again to go on"
    )


class _BrokenError(Exception):
    """An executor broke while these files were in hand."""

    def __init__(self, files: list[str]) -> None:
        self.files = files


def _drained(
    executor: Executor, task: Task, files: deque[str], *, in_hand: int
) -> Iterator[ClipAnnotation]:
    """Yield the rows of all files; those still to be handed out stay in `files`."""
    pending: dict[Future[ClipAnnotation], str] = {}
    while files or pending:
        try:
            while files and len(pending) < in_hand:
                future = executor.submit(task, files[0])
                pending[future] = files.popleft()
        except BrokenExecutor:
            # The file was not taken; what broke is among those in hand.
            if not pending:
                raise _BrokenError([files.popleft()]) from None
        except RuntimeError as error:
            raise _gone(str(error)) from error
        done, _ = wait(pending, return_when=FIRST_COMPLETED)
        for future in sorted(done, key=lambda one: pending[one]):
            row = _row(future, pending)
            del pending[future]
            yield row


def _row(
    future: Future[ClipAnnotation], pending: dict[Future[ClipAnnotation], str]
) -> ClipAnnotation:
    try:
        return future.result()
    except BrokenExecutor:
        raise _BrokenError(sorted(pending.values())) from None
    except CancelledError:
        raise _gone("their work was canceled") from None
    except Exception as error:
        # The task itself never raises: this is what a cluster says of a worker that died of it.
        told = " ".join(f"{type(error).__name__}: {error}".split())[:160]
        return ClipAnnotation(pending[future], 0, 0, error=f"could not be worked on: {told}")
