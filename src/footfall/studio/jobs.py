"""Long work: one thing at a time beside the live session, with its progress, to be canceled."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from footfall.errors import FootfallError
from footfall.studio.memory import settle_memory

__all__ = ["Canceled", "Job", "Jobs"]


class Canceled(Exception):  # noqa: N818 - nothing went wrong
    """The work was canceled."""


@dataclass(eq=False)
class Job:
    """One piece of long work."""

    title: str
    """What is done."""

    number: int
    """By which it is canceled."""

    changed: Callable[[], None]
    """Called whenever something about it has changed."""

    def __post_init__(self) -> None:
        self.share = 0.0
        self.detail = ""
        self._canceled = threading.Event()

    def cancel(self) -> None:
        """Let it end at its next report."""
        self._canceled.set()

    @property
    def canceled(self) -> bool:
        """Whether it is to end."""
        return self._canceled.is_set()

    def report(self, share: float, detail: str = "") -> None:
        """Say how far it is, 0 to 1, and with what.

        Raises:
            Canceled: If it is to end.
        """
        if self.canceled:
            raise Canceled(self.title)
        self.share, self.detail = share, detail
        self.changed()


class Jobs:
    """Work that is waiting and that is being done, in order."""

    def __init__(self, changed: Callable[[], None], failed: Callable[[str], None]) -> None:
        """Begin without work.

        Args:
            changed: Called whenever something about any work has changed.
            failed: Called with one line where work came to nothing.
        """
        self._changed = changed
        self._failed = failed
        self._executor = ThreadPoolExecutor(max_workers=1, thread_name_prefix="studio-job")
        self._jobs: list[Job] = []
        self._lock = threading.Lock()
        self._count = 0

    @property
    def present(self) -> tuple[Job, ...]:
        """All work that is not over."""
        with self._lock:
            return tuple(self._jobs)

    def begin(self, title: str, work: Callable[[Job], None]) -> Job:
        """Do some work, after what was begun before."""
        with self._lock:
            self._count += 1
            job = Job(title, self._count, self._changed)
            self._jobs.append(job)
        self._changed()
        self._executor.submit(self._do, job, work)
        return job

    def cancel(self, number: int) -> None:
        """Cancel some work, whether it has begun or not; one that is over stays as it is."""
        for job in self.present:
            if job.number == number:
                job.cancel()
        self._changed()

    def wait(self) -> None:
        """Return once everything begun so far is over."""
        self._executor.submit(lambda: None).result()

    def close(self) -> None:
        """Cancel everything."""
        for job in self.present:
            job.cancel()
        self._executor.shutdown(wait=False, cancel_futures=True)

    def _do(self, job: Job, work: Callable[[Job], None]) -> None:
        try:
            job.report(0.0)
            work(job)
        except Canceled:
            self._failed(f"canceled: {job.title}")
        except FootfallError as error:
            self._failed(str(error))
        except (MemoryError, OSError) as error:
            self._failed(f"{job.title}: {str(error) or type(error).__name__}")
        except Exception as error:
            # Whatever went wrong in one file must not end the session of all tabs.
            self._failed(f"{job.title}: unexpected {type(error).__name__}: {error}")
        finally:
            settle_memory()
            with self._lock:
                self._jobs.remove(job)
            self._changed()
