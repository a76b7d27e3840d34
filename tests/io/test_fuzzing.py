"""Whatever is in a file: a clip, or one typed error; no traceback, no hang, no endless memory.

Readers that start a process a file take 0.2 s each: of them `make full` reads 2 000, and
20 000 where FOOTFALL_FUZZ says so.
"""

from __future__ import annotations

import os
import resource
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.io.mutations import mutations
from tests.io.small_biped import biped_clip
from tests.io.small_fbx import fbx_text
from tests.io.small_usd import usd_text

from footfall.errors import FootfallError
from footfall.io import load, load_supports, save, save_supports
from footfall.robots import (
    humanoid_mjcf,
    load_robot,
    load_robot_motion,
    our_robot,
    perform_on_robot,
    save_robot_motion,
)
from footfall.samples import sample
from footfall.support import SupportSequence

QUICK = {"fbx": 25, "usda": 15, "usdc": 15, "csv": 400, "parquet": 300, "robot": 400, "mjcf": 200}
FULL = {
    "fbx": 2_000,
    "usda": 2_000,
    "usdc": 2_000,
    "csv": 20_000,
    "parquet": 20_000,
    "robot": 20_000,
    "mjcf": 20_000,
}
MEGABYTE = 1e6

Reader = Callable[[Path], object]


def seed_file(kind: str, folder: Path) -> tuple[bytes, str, Reader]:
    """Return a sound file of a kind, its suffix, and what reads it."""
    clip = biped_clip(frames=4)
    labels = SupportSequence.parse("R.4 D.1 L.4 D.1*")
    if kind == "fbx":
        return fbx_text(clip), ".fbx", load
    if kind == "usda":
        return usd_text(clip), ".usda", load
    if kind == "usdc":
        pytest.importorskip("pxr")
        save(clip, folder / "seed.usdc")
        return (folder / "seed.usdc").read_bytes(), ".usdc", load
    if kind == "mjcf":
        pytest.importorskip("mujoco")
        return humanoid_mjcf().encode(), ".xml", load_robot
    if kind == "robot":
        pytest.importorskip("mujoco")
        robot = our_robot()
        moves = perform_on_robot(robot, *sample("run"))
        save_robot_motion(moves, robot, folder / "seed.npz")
        return (folder / "seed.npz").read_bytes(), ".npz", load_robot_motion
    pytest.importorskip("pyarrow")
    save_supports(labels, folder / f"seed.{kind}")
    return (folder / f"seed.{kind}").read_bytes(), f".{kind}", load_supports


def refusal(read: Reader, path: Path) -> str:
    """Return what is said about a file; nothing where it is read."""
    try:
        read(path)
    except FootfallError as error:
        return str(error)
    return ""


def peak_memory() -> float:
    """Return the greatest memory of this process and of any child so far [bytes]."""
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return 1024.0 * max(resource.getrusage(one).ru_maxrss for one in who)


def fuzz(kind: str, count: int, folder: Path, seed: int) -> None:
    data, suffix, read = seed_file(kind, folder)
    path = folder / f"damaged{suffix}"
    path.write_bytes(data)
    read(path)
    baseline = peak_memory()
    for damaged in mutations(data, count, seed):
        path.write_bytes(damaged)
        began = time.perf_counter()
        assert "\n" not in refusal(read, path)
        taken = time.perf_counter() - began
        assert taken < 10.0 + 2.0 * len(damaged) / MEGABYTE
    assert peak_memory() - baseline < 20 * len(data) + 64 * MEGABYTE


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("kind", QUICK)
def test_a_damaged_file_is_a_typed_error_or_a_clip(kind: str, tmp_path: Path) -> None:
    fuzz(kind, QUICK[kind], tmp_path, seed=1)


@pytest.mark.full
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("kind", QUICK)
def test_twenty_thousand_damaged_files_are_typed_errors_or_clips(kind: str, tmp_path: Path) -> None:
    fuzz(kind, int(os.environ.get("FOOTFALL_FUZZ", FULL[kind])), tmp_path, seed=2)


@pytest.mark.parametrize("kind", ["csv", "parquet", "robot"])
def test_a_file_cut_short_anywhere_is_a_typed_error_or_a_clip(kind: str, tmp_path: Path) -> None:
    data, suffix, read = seed_file(kind, tmp_path)
    path = tmp_path / f"cut{suffix}"
    cuts = range(len(data)) if len(data) < 4000 else np.linspace(0, len(data) - 1, 300).astype(int)
    for cut in cuts:
        path.write_bytes(data[: int(cut)])
        assert "\n" not in refusal(read, path)
