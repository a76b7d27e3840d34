"""Compiling every kernel before it is needed, and saying so."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from typing import TextIO

from footfall.compilation import is_compiled
from footfall.engine import Crowd, MotionLibrary
from footfall.engine.pose_compiling import compile_poses
from footfall.samples import sample
from footfall.sync.tables import Planner

__all__ = ["compiling_beside", "warmup"]


@contextlib.contextmanager
def compiling_beside() -> Generator[None]:
    """Let a second process compile the pose stages meanwhile, where nothing is compiled yet.

    It takes a third from the first start on a machine with two processors. Nothing depends on it:
    what it does not finish in time is compiled here.
    """
    if is_compiled("advance_blocks") or (os.cpu_count() or 1) < 2:
        yield
        return
    silent = subprocess.DEVNULL
    command = [sys.executable, "-m", "footfall.warming"]
    with subprocess.Popen(command, stdin=silent, stdout=silent, stderr=silent) as other:
        try:
            yield
        finally:
            other.terminate()


def warmup(stream: TextIO | None = None) -> float:
    """Compile what the engine needs, so that no later frame has to wait for it.

    Machine code is kept in the user's cache folder: it takes up to half a minute once for each
    version, and under a second from then on.

    Args:
        stream: Where progress is told, one line a step; by default standard error.

    Returns:
        How long it took [s].
    """
    out = sys.stderr if stream is None else stream
    begin = time.perf_counter()
    library = MotionLibrary()
    steps: tuple[tuple[str, Callable[[], None]], ...] = (
        ("motions", lambda: _ready_motions(library)),
        ("commands and planner", lambda: _command(library, "footfall")),
        ("schedules as printed", lambda: _command(library, "paper")),
    )
    with compiling_beside():
        for number, (words, step) in enumerate(steps, start=1):
            print(f"footfall: preparing kernels, {number} of {len(steps)}: {words}", file=out)
            step()
    seconds = time.perf_counter() - begin
    print(f"footfall: kernels ready after {seconds:.1f} s", file=out)
    return seconds


def _ready_motions(library: MotionLibrary) -> None:
    library.add("walk", *sample("walk"))
    library.add("run", *sample("run"))


def _command(library: MotionLibrary, planner: Planner) -> None:
    crowd = Crowd(library, 2, planner=planner)
    for action in range(2):
        crowd.start(action)
        crowd.advance(1.0 / 60.0)
    crowd.set_priority(0, 2.0)
    crowd.stop(1)
    crowd.advance(1.0 / 60.0)
    _ = crowd.world_positions


def _compile_poses() -> None:
    library = MotionLibrary()
    library.add("walk", *sample("walk"))
    compile_poses(Crowd(library, 2))


if __name__ == "__main__":
    _compile_poses()
