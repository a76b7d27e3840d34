"""`import footfall` stays light: a viewer, a file library or SciPy is loaded when it is used."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
from pathlib import Path

import pytest

LATE = ("scipy", "cyclopts", "rich", "http")
TIMER = "import time; start = time.perf_counter(); import {}; print(time.perf_counter() - start)"


def run(code: str, **variables: str) -> str:
    command = [sys.executable, "-c", code]
    environment = {**os.environ, **variables}
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, check=True
    ).stdout


def loaded(module: str) -> set[str]:
    """Return all modules in memory once this one is imported."""
    return set(run(f"import sys, {module}; print(*sys.modules)").split())


def late_modules(names: set[str]) -> list[str]:
    return sorted(name for name in names if name.split(".")[0] in LATE)


def test_importing_loads_none_of_the_late_ones() -> None:
    # Numba itself looks whether SciPy is there.
    assert late_modules(loaded("footfall") - loaded("numba")) == []


@pytest.mark.parametrize("module", ["rich", "http.client", "scipy.spatial"])
def test_a_late_one_that_is_loaded_is_noticed(module: str) -> None:
    assert late_modules(loaded(module) - loaded("numba")) != []


def test_importing_takes_little_longer_than_importing_numba(tmp_path: Path) -> None:
    # By turns, so that both see the same machine; once before, so that bytecode is kept, which
    # an environment may forbid.
    kept = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": str(tmp_path)}
    times: dict[str, list[float]] = {"numba": [], "footfall": []}
    for module in times:
        run(TIMER.format(module), **kept)
    for _ in range(3):
        for module, seconds in times.items():
            seconds.append(float(run(TIMER.format(module), **kept)))
    bare, ours = (statistics.median(times[module]) for module in ("numba", "footfall"))
    assert ours <= 1.6 * bare + 0.15, f"footfall {ours:.2f} s, numba alone {bare:.2f} s"
