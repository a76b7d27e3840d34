"""Whenever the writer is killed, the file is the old one or the new one, never half of either."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

WRITER = """
import sys
from pathlib import Path

from footfall.io import write_atomically

path, size = Path(sys.argv[1]), int(sys.argv[2])
number = 0
print("ready", flush=True)
while True:
    number += 1
    write_atomically(path, bytes([number % 251]) * size)
"""

SIZE = 3_000_000
"""Large enough that most kills come in the middle of a write."""


def killed_once(path: Path, seconds: float) -> None:
    """Let a process write again and again, and kill it after a time without any warning."""
    command = [sys.executable, "-c", WRITER, str(path), str(SIZE)]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as writer:
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"ready\n"
        time.sleep(seconds)
        os.kill(writer.pid, signal.SIGKILL)


@pytest.mark.full
@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
def test_a_writer_killed_at_any_moment_leaves_one_whole_file(tmp_path: Path) -> None:
    path = tmp_path / "walk.npz"
    old = b"the old file"
    path.write_bytes(old)
    dice = random.Random(4)
    interrupted = 0
    for _ in range(25):
        killed_once(path, dice.uniform(0.0, 0.05))
        data = path.read_bytes()
        assert data == old or (len(data) == SIZE and len(set(data)) == 1)
        left = [other for other in tmp_path.iterdir() if other != path]
        interrupted += len(left)
        for other in left:
            assert other.name.startswith(".walk.npz.")
            assert other.suffix == ".part"
            other.unlink()
    assert interrupted > 5, "no write was cut off: nothing was tested"
