"""Same inputs, same bits: twice in a row, and in another process."""

from __future__ import annotations

import subprocess
import sys

PERFORMANCE = """
import hashlib

import footfall as ff

walk, supports = ff.sample("walk")
hero = ff.Character(walk.skeleton)
hero.add("walk", walk, supports)
hero.add("run", *ff.sample("run"), priority=2.0)
digest = hashlib.sha256()
for frame in range(200):
    if frame == 0:
        hero.start("walk")
    if frame == 61:
        hero.start("run")
    if frame == 117:
        hero.stop("walk")
    shown = hero.advance(1 / 60)
    digest.update(shown.world_positions.tobytes() + shown.world_rotations.tobytes())
print(digest.hexdigest())
"""


def bits() -> str:
    """Return a digest of every joint in every frame of a performance in a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", PERFORMANCE], check=True, capture_output=True, text=True
    ).stdout


def test_another_process_gives_the_same_bits() -> None:
    one = bits()
    assert len(one.strip()) == 64
    assert bits() == one
