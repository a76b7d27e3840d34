"""Threads that share the blocks of a crowd.

Every block of eight is worked on by one thread, with memory of its own, and depends on no other
block: how many threads there are, and which one takes what, changes no bit of the result.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from footfall.engine.record import SEATS
from footfall.engine.state import Workspace, new_workspace
from footfall.errors import ArgumentError
from footfall.octets import LANES
from footfall.sync.search_memory import new_planner_memory

__all__ = ["Workers"]

SERIAL_BELOW = 2048
"""Characters up to which one thread is faster: waking another takes as long as they do."""

SHARE = 128
"""Blocks that a thread takes at a time."""

Task = Callable[[int, int, int], None]
"""What a thread does, by its number, with blocks: the first one, and the one after the last."""


class Workers:
    """Some threads, each with its own memory to work in."""

    def __init__(self, threads: int | None, lookahead: int) -> None:
        """Prepare threads; they start when they are needed first.

        Args:
            threads: How many, >= 1; None: one for each processor that may be used.
            lookahead: How many slots ahead the characters decide.

        Raises:
            ArgumentError: If there is no thread.
        """
        if threads is None:
            threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
        if threads < 1:
            raise ArgumentError(f"{threads} threads; a crowd needs at least 1")
        self.threads = threads
        """How many there are."""
        self._lookahead = lookahead
        self._workspaces: dict[int, list[Workspace]] = {}
        self.search = new_planner_memory(SEATS, lookahead)
        """Memory of the planner for who gives commands."""
        self._executor: ThreadPoolExecutor | None = None

    def workspaces(self, joints: int) -> list[Workspace]:
        """Return the memory of each thread for bodies of so many joints."""
        if joints not in self._workspaces:
            self._workspaces[joints] = [
                new_workspace(joints, self._lookahead) for _ in range(self.threads)
            ]
        return self._workspaces[joints]

    def run(self, task: Task, blocks: int) -> None:
        """Work on all blocks, and wait until everything is done."""
        if self.threads == 1 or blocks * LANES < SERIAL_BELOW:
            task(0, 0, blocks)
            return
        if self._executor is None:
            self._executor = ThreadPoolExecutor(self.threads - 1, "footfall")
        shares = itertools.count(0, SHARE)

        def take_shares(thread: int) -> None:
            # Taking the next number of a count is one step for the interpreter: no two get one.
            for first in shares:
                if first >= blocks:
                    return
                task(thread, first, min(first + SHARE, blocks))

        others = [self._executor.submit(take_shares, one) for one in range(1, self.threads)]
        take_shares(0)
        for other in others:
            other.result()
