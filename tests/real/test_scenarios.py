"""Twelve cue sheets over real clips, by each method, and what must hold of them.

`pytest -s tests/real/test_scenarios.py` prints the tables. The cue sheets stand in `scenarios/`;
all their clips are cleaned at import.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.arrays import Floats
from footfall.cli.measuring import Comparison, compare
from footfall.report import (
    Group,
    SourceSlips,
    SpanMeasure,
    Track,
    mean_source_slips,
    measure_spans,
    performance_trace,
    text_table,
)
from footfall.report.track import resampled_labels
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.motions import Motion
from footfall.scenario.performance import Performance
from footfall.skeleton import Anatomy, find_anatomy, leg_length

FOLDER = Path(__file__).parents[3] / "shared" / "motions"
SHEETS = sorted((Path(__file__).parent / "scenarios").glob("*.toml"))
pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="no ../shared/motions")

METHODS = ("cross-fade", "paper", "no-footprints", "footfall")
FADED = (Group.TRANSITIONS, Group.MIXES)


class Pool:
    """What is measured of one method, over all cue sheets."""

    def __init__(self) -> None:
        self.spans: list[SpanMeasure] = []

    def values(self, what: str, group: Group | None = None) -> Floats:
        """Return a measure of all spans, or of those of one group [mm]."""
        found = [
            getattr(each, what) for each in self.spans if group is None or each.span.group is group
        ]
        return 1e3 * np.array([value for value in found if value is not None])


def _feet(performance: Performance, motion: Motion) -> Anatomy:
    alike = motion.clip.skeleton.names == performance.recording.skeleton.names
    return performance.anatomy if alike else find_anatomy(motion.clip.skeleton)


def spans_of(performance: Performance) -> tuple[SpanMeasure, ...]:
    recording = performance.recording
    sources = [
        SourceSlips.of(motion.clip, _feet(performance, motion), motion.supports)
        for motion in performance.motions
    ]
    times = np.nan_to_num(recording.clip_times)
    slips = mean_source_slips(sources, times, recording.shares)
    track = Track.from_trace(performance_trace(performance))
    return measure_spans(track, resampled_labels(slips, recording.fps))


@pytest.fixture(scope="module")
def comparisons() -> dict[str, Comparison]:
    assert len(SHEETS) == 13
    return {
        sheet.stem: compare(parse_scenario(sheet.read_text(encoding="utf-8"), FOLDER / sheet.name))
        for sheet in SHEETS
    }


@pytest.fixture(scope="module")
def pools(comparisons: dict[str, Comparison]) -> dict[str, Pool]:
    result = {method: Pool() for method in METHODS}
    for comparison in comparisons.values():
        for method in METHODS:
            result[method].spans += spans_of(comparison.performances[method])
    return result


@pytest.fixture(scope="module")
def ours(comparisons: dict[str, Comparison]) -> list[Performance]:
    return [comparison.performances["footfall"] for comparison in comparisons.values()]


def p95(values: Floats) -> float:
    return float(np.percentile(values, 95.0))


def test_every_sheet_and_all_together_in_tables(
    comparisons: dict[str, Comparison], pools: dict[str, Pool]
) -> None:
    clips = {motion.clip.name for c in comparisons.values() for motion in _motions(c)}
    for name, comparison in comparisons.items():
        print(f"\n{name}\n{text_table(comparison.reports)}")
    print(f"\nall {len(comparisons)} sheets; median / p95 in mm")
    for method, pool in pools.items():
        cells: list[str] = []
        for what, group in (
            ("inner_slip", Group.ALONE),
            *(("inner_slip", group) for group in FADED),
            *(("excess", group) for group in FADED),
            ("inner_drift", None),
        ):
            values = pool.values(what, group)
            cells.append(
                f"{what} {group.value if group else 'all'} {np.median(values):.1f} / "
                f"{p95(values):.1f} ({len(values)})"
            )
        print(f"{method:14}" + "; ".join(cells))
    print(f"{len(clips)} clips, 0 skipped")
    slips = {method: pools[method].values("inner_slip") for method in METHODS}
    assert p95(slips["cross-fade"]) > 20.0 * p95(slips["footfall"])


def _motions(comparison: Comparison) -> tuple[Motion, ...]:
    return comparison.performances["footfall"].motions


@pytest.mark.parametrize("group", FADED)
def test_without_footprints_feet_slide_little_more_than_in_the_clips(
    pools: dict[str, Pool], group: Group
) -> None:
    excess = pools["no-footprints"].values("excess", group)
    assert len(excess) >= 20
    assert np.median(excess) <= 5.0
    assert p95(excess) <= 15.0


def test_with_footprints_planted_feet_stay(pools: dict[str, Pool]) -> None:
    assert p95(pools["footfall"].values("inner_drift")) <= 5.0


def test_the_lock_moves_feet_little(ours: list[Performance]) -> None:
    offsets = np.concatenate([one.recording.foot_offsets for one in ours])
    far, farthest = 1e3 * p95(offsets), 1e3 * offsets.max()
    print(f"\nthe lock moves feet by {far:.1f} mm (p95), {farthest:.1f} mm (max)")
    assert p95(offsets) <= 0.035


def test_no_leg_over_reaches(ours: list[Performance]) -> None:
    for one in ours:
        skeleton = one.recording.skeleton
        for leg in find_anatomy(skeleton).legs:
            ends = one.recording.world_positions[:, [leg.hip, leg.ankle]]
            reach = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
            assert reach.max() <= leg_length(skeleton, leg) * (1.0 + 1e-6)


def test_the_root_is_not_jerked(comparisons: dict[str, Comparison]) -> None:
    ratios = {
        name: comparison.reports["footfall"].pop_ratios for name, comparison in comparisons.items()
    }
    told = {name: one.root_acceleration_p99 for name, one in ratios.items() if one is not None}
    print("\nroot acceleration p99 over the clips': ", {k: round(v, 2) for k, v in told.items()})
    assert len(told) == 13
    assert max(told.values()) <= 1.2


def test_nothing_pops(comparisons: dict[str, Comparison]) -> None:
    ratios = [comparison.reports["footfall"].pop_ratios for comparison in comparisons.values()]
    assert max(one.acceleration_p999 for one in ratios if one is not None) <= 1.5
    assert max(one.speed_p999 for one in ratios if one is not None) <= 1.5


def test_feet_do_what_was_commanded(comparisons: dict[str, Comparison]) -> None:
    overall: list[tuple[float, int]] = []
    moving: list[tuple[float, int]] = []
    for comparison in comparisons.values():
        mismatch = comparison.reports["footfall"].mismatch
        recording = comparison.performances["footfall"].recording
        assert mismatch is not None
        if mismatch.overall is not None:
            overall.append((mismatch.overall, recording.frames))
        if mismatch.transitions is not None:
            moving.append((mismatch.transitions, int(recording.moving.sum())))
    share, faded = (_mean(each) for each in (overall, moving))
    print(f"\nmismatch {100 * share:.1f} %, in transitions {100 * faded:.1f} %")
    assert share <= 0.05
    assert faded <= 0.08


def _mean(shares: list[tuple[float, int]]) -> float:
    frames = sum(count for _, count in shares)
    return sum(share * count for share, count in shares) / frames


def test_a_fade_takes_at_most_twice_the_time_asked(ours: list[Performance]) -> None:
    longest = 0.0
    for one in ours:
        asked = max(max(entry.fade_in, entry.fade_out) for entry in one.scenario.actions)
        moving = one.recording.moving
        edges = np.flatnonzero(np.diff(np.concatenate([[False], moving, [False]]).astype(int)))
        for start, end in edges.reshape(-1, 2):
            cues = [cue for cue in one.scenario.cues if start / 60 - 0.1 <= cue.at <= end / 60]
            if len(cues) == 1:
                longest = max(longest, (end - start) / 60 / (2.0 * asked))
    assert 0.25 < longest <= 1.0 + 2.0 / 60.0 / 0.3
