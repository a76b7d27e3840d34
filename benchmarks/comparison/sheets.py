"""Every cue sheet played by every method, and what is measured of it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Floats
from footfall.cli.measuring import Comparison, compare
from footfall.report import (
    Delay,
    Group,
    MethodReport,
    ScheduleReport,
    Track,
    measure_schedule,
    measure_spans,
    performance_trace,
    played_phases,
)
from footfall.scenario.cue_sheet import Scenario, parse_scenario
from footfall.scenario.methods import METHODS
from footfall.scenario.performance import Performance, load_motions
from footfall.scenario.playing import Play
from footfall.scenario.preparation import prepare_character

ROOT = Path(__file__).parents[2]
SAMPLES = Path(__file__).parent / "cue_sheets"
CAPTURED = ROOT / "tests" / "real" / "scenarios"
CLIPS = ROOT.parent / "shared" / "motions"

MILLIMETERS = 1e3
"""In a meter."""


@dataclass(frozen=True, eq=False)
class MethodResult:
    """One cue sheet by one method."""

    report: MethodReport
    """Slip, drift, mismatch, pops."""

    schedule: ScheduleReport
    """Stretch, delays, rates."""

    blended_slips: Floats
    """Inner slip of each support span in which weights moved or several motions had some [mm]."""

    cost: float
    """Processor time of one tick of 1/60 s [µs]."""


@dataclass(frozen=True, eq=False)
class SheetResult:
    """One cue sheet by every method."""

    name: str
    """Of its file."""

    told: str
    """What happens in it: its first line."""

    captured: bool
    """Whether its clips are captured ones, which the project does not contain."""

    methods: dict[str, MethodResult]
    """By the name of the method."""

    performances: dict[str, Performance]
    """What each made of it."""


def sheets() -> list[tuple[Path, Path]]:
    """Return each cue sheet with the folder in which its clips are; without captured clips ours."""
    found = [(path, SAMPLES) for path in sorted(SAMPLES.glob("*.toml"))]
    if CLIPS.is_dir():
        found += [(path, CLIPS) for path in sorted(CAPTURED.glob("*.toml"))]
    return found


def play_sheets() -> Iterator[SheetResult]:
    """Play every cue sheet by every method."""
    for path, folder in sheets():
        text = path.read_text(encoding="utf-8")
        scenario = parse_scenario(text, folder / path.name)
        comparison = compare(scenario)
        costs = _costs(scenario)
        yield SheetResult(
            path.stem,
            text.splitlines()[0].removeprefix("# "),
            folder == CLIPS,
            {name: _result(comparison, name, costs[name]) for name in METHODS},
            dict(comparison.performances),
        )


def _result(comparison: Comparison, name: str, cost: float) -> MethodResult:
    performance = comparison.performances[name]
    spans = measure_spans(Track.from_trace(performance_trace(performance)))
    slips = [
        MILLIMETERS * each.inner_slip
        for each in spans
        if each.span.group is not Group.ALONE and each.inner_slip is not None
    ]
    return MethodResult(comparison.reports[name], schedule_of(performance), np.array(slips), cost)


def schedule_of(performance: Performance) -> ScheduleReport:
    """Measure how phases were stretched and starts delayed, whatever the method."""
    recording = performance.recording
    played = [
        played_phases(recording.clip_times[:, i], motion.supports, recording.fps)
        for i, motion in enumerate(performance.motions)
    ]
    lasted = [len(list(group)) / recording.fps for _, group in groupby(performance.supports)]
    delays = [Delay(one.commanded, one.actual, one.reason) for one in performance.starts]
    return measure_schedule(played, lasted[1:-1], delays, recording.rates)


def _costs(scenario: Scenario) -> dict[str, float]:
    """Return how long one tick takes by each method [µs]: processor time of this thread."""
    motions = load_motions(scenario)
    costs: dict[str, float] = {}
    for name, method in METHODS.items():
        character, ground = prepare_character(
            scenario,
            motions,
            0,
            planner=method.planner,
            synchronized=method.synchronized,
            footprints=method.footprints,
            pacing=None if method.pacing is None else method.pacing(),
        )
        spent: list[float] = []
        advance: Any = character.advance

        def timed(dt: float, advance: Any = advance, spent: list[float] = spent) -> Any:
            begin = time.thread_time()
            frame = advance(dt)
            spent.append(time.thread_time() - begin)
            return frame

        character.advance = timed
        Play(character, scenario, ground).play()
        costs[name] = 1e6 * float(np.mean(spent))
    return costs
