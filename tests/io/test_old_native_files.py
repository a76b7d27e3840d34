"""Native files of every version there has been are read: kept, never made anew."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from footfall.io import load, load_native_supports
from footfall.io.native import VERSION

KEPT = Path(__file__).parents[1] / "golden" / "native"

DIGESTS = {"version_1.npz": "469adc58c9504448d846ad1fe99bc902cc619eacc269bf5f65200e72f0b15a2e"}
"""What each was when it was kept."""


def test_there_is_one_of_each_version() -> None:
    names = sorted(path.name for path in KEPT.glob("*.npz"))
    assert names == [f"version_{number}.npz" for number in range(1, VERSION + 1)]


@pytest.mark.parametrize("name", DIGESTS)
def test_it_is_the_file_that_was_kept(name: str) -> None:
    assert hashlib.sha256((KEPT / name).read_bytes()).hexdigest() == DIGESTS[name]


def test_version_1_reads_as_it_was_written() -> None:
    clip = load(KEPT / "version_1.npz")
    supports = load_native_supports(KEPT / "version_1.npz")
    assert (clip.name, clip.frames, clip.fps, clip.cyclic) == ("walk-to-hop", 47, 15.0, False)
    assert clip.provenance == ("made by footfall as sample 'walk-to-hop'",)
    assert str(supports) == "R.4 D.12 L.4 D.12 R.36 -.22 R.28 -.22 R.4 D.547"
    assert clip.pelvis_positions[0].tolist() == pytest.approx([-0.012, 0.915, 0.0], abs=1e-6)
    assert clip.pelvis_positions[-1].tolist() == pytest.approx([0.0, 0.935, 2.84], abs=1e-6)
    assert clip.local_rotations.sum() == pytest.approx(987.177, abs=1e-4)
