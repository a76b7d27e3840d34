"""What a process pays before its first frame: import, cached kernels, cold compile."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile

from footfall.benchmark.rows import Row

__all__ = ["process_rows"]

TIMER = "import time; a = time.process_time(); {}; print(time.process_time() - a)"

FIRST_TICK = (
    "import footfall as ff; walk = ff.sample('walk'); h = ff.Character(walk[0].skeleton); "
    "a = time.process_time(); h.add('walk', *walk); h.start('walk'); h.advance(1 / 60)"
)


def _processor_seconds(statement: str, cache: str | None = None) -> float:
    """Return the processor time that a statement takes in a new process [s]."""
    # Bytecode is kept, which an environment may forbid: it is for users.
    variables = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}
    if cache is not None:
        variables["XDG_CACHE_HOME"] = cache
    found = subprocess.run(
        [sys.executable, "-c", TIMER.format(statement)],
        env=variables,
        check=True,
        capture_output=True,
        text=True,
    )
    return float(found.stdout)


def process_rows() -> list[Row]:
    """Measure new processes."""
    for module in ("numba", "footfall"):
        _processor_seconds(f"import {module}")
    bare = statistics.median(_processor_seconds("import numba") for _ in range(5))
    ours = statistics.median(_processor_seconds("import footfall") for _ in range(5))
    with tempfile.TemporaryDirectory(prefix="footfall-") as cache:
        cold = _processor_seconds(FIRST_TICK, cache)
        cached = statistics.median(_processor_seconds(FIRST_TICK, cache) for _ in range(3))
    return [
        Row("import_ratio", ours / bare, 1.6, "times a bare import of numba"),
        Row("cached_first_tick_s", cached, 0.5, "s of processor time"),
        Row("cold_compile_s", cold, 25.0, "s of processor time"),
    ]
