"""Annotate ten thousand clips of 6 s on two cores: the bound is five minutes.

Run as ``python benchmarks/annotate_archive.py [FILES] [WORKERS]``. The clips are made from the
project's own samples: each cyclic one unrolled from an arbitrary moment on, its feet made to slide
a little; 200 different ones, linked until there are enough.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from functools import partial
from pathlib import Path

import numpy as np

from footfall.datasets import annotate_archive, local_pool
from footfall.io import save_bvh
from footfall.motion import Clip
from footfall.motion.sampling import sample as poses_at
from footfall.samples import sample, sample_names

__all__ = ["main", "make_archive"]

SECONDS, FPS = 6.0, 60.0
DIFFERENT = 200
BOUND_SECONDS = 300.0


def make_archive(folder: Path, files: int) -> None:
    """Write so many clips of 6 s."""
    random = np.random.default_rng(0)
    cyclic = [name for name in sample_names() if sample(name)[0].cyclic]
    for index in range(files):
        place = folder / f"{index // 1000:02d}" / f"clip{index:05d}.bvh"
        place.parent.mkdir(exist_ok=True)
        if index >= DIFFERENT:
            number = index % DIFFERENT
            os.link(folder / f"{number // 1000:02d}" / f"clip{number:05d}.bvh", place)
            continue
        clip, _ = sample(cyclic[index % len(cyclic)])
        times = random.uniform(0.0, clip.duration) + np.arange(round(SECONDS * FPS) + 1) / FPS
        pelvis, rotations = poses_at(clip, times)
        pelvis[:, 0] += 0.05 * np.sin(times * random.uniform(0.5, 3.0))
        rotations /= np.linalg.norm(rotations, axis=-1, keepdims=True)
        save_bvh(Clip(clip.skeleton, pelvis, rotations, FPS), place)


def main() -> None:
    """Make the archive, annotate it, and say how long that took."""
    files = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    workers = int(sys.argv[2]) if len(sys.argv) > 2 else 2
    with tempfile.TemporaryDirectory() as scratch:
        archive = Path(scratch) / "archive"
        archive.mkdir()
        make_archive(archive, files)
        began = time.perf_counter()
        summary = annotate_archive(
            archive, Path(scratch) / "out", executors=partial(local_pool, workers)
        )
        seconds = time.perf_counter() - began
    print(
        f"{summary.files} clips of {SECONDS:g} s, {summary.failed} not usable, {workers} workers: "
        f"{seconds:.1f} s, {files / seconds:.0f} files/s; bound {BOUND_SECONDS:g} s"
    )


if __name__ == "__main__":
    main()
