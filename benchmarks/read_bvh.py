"""How many joint-frames of BVH a second ours reads, and the readers on PyPI, in one run.

    python benchmarks/read_bvh.py [FILE.bvh]

Without a file, a walk of ours is written and read. Times are those of the processor, so that
other programs on the machine count less. Readers that are not installed are left out;
`pip install -e '.[dev-readers]'` brings two of them.
"""

from __future__ import annotations

import importlib
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from footfall.io import load_bvh, save_bvh
from footfall.io.bvh_rig import parse_bvh
from footfall.samples import sample


def written(folder: Path) -> Path:
    """Write a walk of some minutes and return its path."""
    clip, _ = sample("walk")
    times = 80
    places = np.tile(clip.pelvis_positions, (times, 1))
    long = clip.evolve(
        pelvis_positions=places,
        local_rotations=np.tile(clip.local_rotations, (times, 1, 1)),
        cyclic=False,
    )
    save_bvh(long, folder / "walk.bvh")
    return folder / "walk.bvh"


def seconds(read: Callable[[Path], object], path: Path) -> float:
    """Return the shortest of three readings [s]; the first one only warms up."""
    taken: list[float] = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for _ in range(4):
            start = time.process_time()
            read(path)
            taken.append(time.process_time() - start)
    return min(taken[1:])


def readers() -> dict[str, Callable[[Path], object]]:
    """Return what reads a BVH file."""
    found: dict[str, Callable[[Path], object]] = {
        "footfall, the file alone": lambda path: parse_bvh(path.read_bytes(), path),
        "footfall, with all conclusions": load_bvh,
    }
    others: dict[str, Callable[[Any, Path], object]] = {
        "pybvh": lambda module, path: module.read_bvh_file(str(path)),
        "bvhio": lambda module, path: module.readAsBvh(str(path)),
        "pymotion.io.bvh": lambda module, path: module.BVH().load(str(path)),
        "bvh": lambda module, path: module.Bvh(path.read_text()),
    }
    for name, read in others.items():
        try:
            module = importlib.import_module(name)
        except ImportError:
            print(f"{name:<32} not installed")
            continue
        found[name] = lambda path, read=read, module=module: read(module, path)
    return found


def main() -> None:
    """Measure and print."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(sys.argv[1]) if len(sys.argv) > 1 else written(Path(folder))
        clip = load_bvh(path)
        count = clip.frames * clip.skeleton.count
        print(f"{path.name}: {clip.frames} frames of {clip.skeleton.count} joints, "
              f"{path.stat().st_size / 1e6:.1f} MB")  # fmt: skip
        for name, read in readers().items():
            taken = seconds(read, path)
            print(f"{name:<32} {count / taken / 1e6:8.2f} million joint-frames a second")


if __name__ == "__main__":
    main()
