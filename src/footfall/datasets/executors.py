"""Who does the work: the cores of this machine, or a Dask cluster."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from typing import Any

from footfall.errors import ArgumentError
from footfall.extras import extra_module
from footfall.io.guarded_process import keep_children

__all__ = ["dask_executor", "local_pool", "usable_cores"]

CONNECT_SECONDS = 10
"""How long a scheduler may take to answer."""


def usable_cores() -> int:
    """Return on how many cores this process may run."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity is not None else os.cpu_count() or 1


def local_pool(workers: int | None = None) -> Executor:
    """Return a pool of processes on this machine.

    They are spawned, not forked: a forked copy of a program with threads may hang.

    Args:
        workers: How many, >= 1; None: one a core.

    Raises:
        ArgumentError: If `workers` is below 1.
    """
    count = usable_cores() if workers is None else workers
    if count < 1:
        raise ArgumentError(f"workers is {count}; at least one is needed")
    return ProcessPoolExecutor(
        count, mp_context=multiprocessing.get_context("spawn"), initializer=_begin_work
    )


def _begin_work() -> None:
    """Make ready to read many files; leave Ctrl-C to the process that ends the pool."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    keep_children()


def dask_executor(address: str) -> Executor:
    """Return an executor on a Dask cluster.

    Its workers need this package, and must see the archive under the same path.

    Args:
        address: Of the scheduler, such as ``tcp://10.0.0.5:8786``.

    Raises:
        MissingExtraError: If Dask is not installed.
        ArgumentError: If no scheduler answers there.
    """
    distributed = extra_module(
        "distributed", "working on a cluster", extra="dask", library="distributed"
    )
    try:
        client = distributed.Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise ArgumentError(
            f"no Dask scheduler answers at {address!r}: {' '.join(str(error).split())[:120]}"
        ) from error
    return _ClusterExecutor(client)


class _ClusterExecutor(Executor):
    """Dask's own executor, with the shutdown that the standard library has."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self._executor: Any = client.get_executor(pure=False)

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = self._executor.submit(fn, *args, **kwargs)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        self._executor.shutdown(wait=wait and not cancel_futures)
        self._client.close()
