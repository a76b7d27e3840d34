"""The supports of every real clip, in a table, and what must hold of them.

`pytest -s tests/real/test_supports.py` prints the table.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.detection.carried_slip import sharpest

from footfall.detection import clean_and_tell, detect_supports
from footfall.io import load
from footfall.motion import Clip, cut_cycle
from footfall.report import Track, clip_trace, measure_spans
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import SupportSequence

FOLDER = Path(__file__).parents[3] / "shared" / "motions"
MANIFEST = FOLDER / "manifest.json"
needs_clips = pytest.mark.skipif(not MANIFEST.exists(), reason="no ../shared/motions")

WALKS = {"walk", "backward"}
RUNS = {"snu_vsports/cmu16_35_run.bvh.gz", "ozz/pab_jog.bvh.gz", "ozz/pab_run.bvh.gz"}


def records() -> list[Any]:
    """Return what the manifest tells of the BVH clips that are no problems."""
    if not MANIFEST.exists():
        return []
    clips: list[Any] = json.loads(MANIFEST.read_text(encoding="utf-8"))["clips"]
    return [clip for clip in clips if clip["format"] == "bvh.gz" and "unit" in clip]


def opened(file: str) -> tuple[Clip, Anatomy]:
    clip = load(FOLDER / file)
    return clip, find_anatomy(clip.skeleton)


def inner_slips(clip: Clip, supports: SupportSequence, anatomy: Anatomy) -> list[float]:
    """Return the inner slip of each support span [m] (measures, section 1)."""
    track = Track.from_trace(clip_trace(clip, anatomy, supports))
    slips = [measure.inner_slip for measure in measure_spans(track)]
    return [slip for slip in slips if slip is not None]


def symbols(supports: SupportSequence) -> str:
    return "".join(phase.support.symbol for phase in supports.phases)


def rotations_of(text: str) -> set[str]:
    return {text[i:] + text[:i] for i in range(len(text))}


def double_share(supports: SupportSequence) -> float:
    doubles = [p.duration for p in supports.phases if p.support.symbol == "D"]
    return sum(doubles) / supports.duration


@needs_clips
def test_every_clip_in_a_table() -> None:
    heading = (
        f"{'clip':36}{'D %':>5}{'short':>7}{'m/s':>6}"
        f"{'slip med/p95':>14}{'cleaned':>12}{'moved':>7}{'pops':>6}  phases"
    )
    print(f"\n{heading}")
    before: list[float] = []
    after: list[float] = []
    for record in records():
        clip, anatomy = opened(record["file"])
        supports = detect_supports(clip, anatomy)
        told = clean_and_tell(clip, supports, anatomy)
        slips = inner_slips(clip, supports, anatomy) or [0.0]
        cleaned = inner_slips(told.clip, supports, anatomy) or [0.0]
        before += slips
        after += cleaned
        moved = np.linalg.norm(told.foot_offsets, axis=-1).max()
        shortest = min(phase.duration for phase in supports.phases)
        pops = sharpest(told.clip) / sharpest(clip)
        way = (clip.pelvis_positions[-1] - clip.pelvis_positions[0])[[0, 2]]
        print(
            f"{record['file'].split('/')[1].removesuffix('.bvh.gz'):36}"
            f"{100.0 * double_share(supports):5.0f}{shortest:7.3f}"
            f"{np.linalg.norm(way) / clip.duration:6.2f}"
            f"{1e3 * np.median(slips):8.1f}{1e3 * np.percentile(slips, 95.0):6.1f}"
            f"{1e3 * np.median(cleaned):7.1f}{1e3 * np.percentile(cleaned, 95.0):5.1f}"
            f"{1e3 * moved:7.0f}{pops:6.2f}  {str(supports)[:60]}"
        )
        assert supports.duration == pytest.approx(clip.duration, abs=1e-6)
        assert shortest >= 0.06 - 1e-9
        assert pops < 1.25
    print(
        f"{len(records())} clips, 0 skipped; slip of {len(before)} spans [mm]: median "
        f"{1e3 * np.median(before):.1f}, p95 {1e3 * np.percentile(before, 95.0):.1f}; cleaned "
        f"{1e3 * np.median(after):.1f}, {1e3 * np.percentile(after, 95.0):.1f}"
    )
    assert np.median(after) < 0.002
    assert np.percentile(after, 95.0) < 0.006


@needs_clips
@pytest.mark.parametrize(
    "file", [r["file"] for r in records() if WALKS & set(r["tags"])] or ["none"]
)
def test_a_cycle_of_a_walk_is_right_double_left_double(file: str) -> None:
    clip, anatomy = opened(file)
    supports = detect_supports(cut_cycle(clip, anatomy), anatomy)
    assert symbols(supports) in rotations_of("RDLD"), str(supports)
    for phase in supports.phases:
        assert phase.duration >= 0.06 - 1e-9
        if phase.support.symbol == "D":
            assert 0.04 <= phase.duration / supports.duration <= 0.25, str(supports)


@needs_clips
@pytest.mark.parametrize("file", sorted(RUNS))
def test_a_cycle_of_a_run_is_right_flight_left_flight(file: str) -> None:
    clip, anatomy = opened(file)
    supports = detect_supports(cut_cycle(clip, anatomy), anatomy)
    assert symbols(supports) in rotations_of("R-L-"), str(supports)
    assert min(phase.duration for phase in supports.phases) >= 0.06 - 1e-9
