"""How long the demo takes: with nothing compiled yet, and once compiled.

Run as ``python benchmarks/demo.py``; exits with 1 where a budget is not met. Each time is that of
a fresh process, import included.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COLD, WARM = 45.0, 10.0
"""Budgets [s]."""


def demo(cache: Path, output: Path) -> float:
    """Return how long `footfall demo` takes [s] with this folder for compiled kernels."""
    environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
    start = time.perf_counter()
    subprocess.run(
        [sys.executable, "-m", "footfall", "demo", "-o", str(output)],
        check=True,
        env=environment,
        stdout=subprocess.DEVNULL,
    )
    return time.perf_counter() - start


def main() -> int:
    """Print both times beside their budgets; return 1 where one is not met."""
    with tempfile.TemporaryDirectory() as folder:
        cache, output = Path(folder, "cache"), Path(folder, "demo")
        cold, warm = demo(cache, output), demo(cache, output)
    print(f"demo_cold_s  {cold:6.1f}   budget <= {COLD:.0f}")
    print(f"demo_warm_s  {warm:6.1f}   budget <= {WARM:.0f}")
    return int(cold > COLD or warm > WARM)


if __name__ == "__main__":
    sys.exit(main())
