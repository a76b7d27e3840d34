"""The same cues by every method, measured the same way: the rows that convince a user."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from footfall.detection import detect_contacts
from footfall.motion import with_soles
from footfall.report import (
    MethodReport,
    Pops,
    SourceSlips,
    Track,
    clip_trace,
    joint_pops,
    mean_source_slips,
    measure,
    performance_trace,
)
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.methods import METHODS
from footfall.scenario.motions import Motion
from footfall.scenario.performance import Performance, load_motions, perform, support_text
from footfall.skeleton import find_anatomy

__all__ = [
    "Comparison",
    "compare",
    "motion_report",
    "report_json",
    "report_of",
]


@dataclass(frozen=True, eq=False)
class Comparison:
    """One cue sheet by several methods."""

    performances: Mapping[str, Performance]
    """What each method made of it, by its name of `footfall.scenario.methods.METHODS`."""

    reports: Mapping[str, MethodReport]
    """How good that is."""


@dataclass(frozen=True, eq=False)
class _Sources:
    """The motions of a cue sheet as they are measured."""

    slips: tuple[SourceSlips, ...]
    pops: Pops | None

    @classmethod
    def of(cls, motions: tuple[Motion, ...]) -> _Sources:
        slips: list[SourceSlips] = []
        pops: list[Pops] = []
        feet = with_soles(find_anatomy(motions[0].clip.skeleton), *motions[0].clip.world_poses())
        for motion in motions:
            alike = motion.clip.skeleton.names == motions[0].clip.skeleton.names
            anatomy = feet if alike else find_anatomy(motion.clip.skeleton)
            slips.append(SourceSlips.of(motion.clip, anatomy, motion.supports))
            trace = clip_trace(motion.clip, anatomy, motion.supports)
            found = joint_pops(Track.from_trace(trace).joints)
            if found is not None:
                pops.append(found)
        return cls(tuple(slips), Pops.greatest(pops) if pops else None)


def compare(scenario: Scenario) -> Comparison:
    """Play a cue sheet by each method and measure it.

    Raises:
        ScenarioError: If it cannot be played.
    """
    motions = load_motions(scenario)
    sources = _Sources.of(motions)
    performances = {
        name: perform(
            scenario,
            synchronized=method.synchronized,
            footprints=method.footprints,
            planner=method.planner,
            pacing=None if method.pacing is None else method.pacing(),
            motions=motions,
        )
        for name, method in METHODS.items()
    }
    reports = {name: _measured(one, sources) for name, one in performances.items()}
    return Comparison(performances, reports)


def report_of(performance: Performance) -> MethodReport:
    """Measure one performance."""
    return _measured(performance, _Sources.of(performance.motions))


def _measured(performance: Performance, sources: _Sources) -> MethodReport:
    recording = performance.recording
    trace = performance_trace(performance)
    times = np.nan_to_num(recording.clip_times)
    return measure(
        trace,
        contacts=detect_contacts(recording.to_clip(), performance.anatomy).flags,
        source_slips=mean_source_slips(sources.slips, times, recording.shares),
        source_pops=sources.pops,
    )


def motion_report(motion: Motion) -> MethodReport:
    """Measure one motion in its own supports."""
    anatomy = find_anatomy(motion.clip.skeleton)
    contacts = detect_contacts(motion.clip, anatomy).flags
    return measure(clip_trace(motion.clip, anatomy, motion.supports), contacts=contacts)


def report_json(performance: Performance, reports: Mapping[str, MethodReport]) -> dict[str, Any]:
    """Return the report of a cue sheet, ready for JSON."""
    return {
        "fps": performance.recording.fps,
        "frames": performance.recording.frames,
        "supports": support_text(performance.supports),
        "starts": [start.to_json() for start in performance.starts],
        "rows": {name: report.to_json() for name, report in reports.items()},
    }
