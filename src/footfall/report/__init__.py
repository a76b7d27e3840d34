"""Measures of a motion: slip per support span, drift, mismatch, pops, the schedule's cost."""

from footfall.report.comparisons import skating_ratio, weighted_skate
from footfall.report.mismatch import Mismatch, support_mismatch
from footfall.report.performances import performance_trace, recording_trace
from footfall.report.played import played_phases
from footfall.report.pops import Pops, joint_pops
from footfall.report.slip import SpanMeasure, carried_steps, measure_spans
from footfall.report.sources import SourceSlips, clip_trace, mean_source_slips
from footfall.report.spans import Group, Span, runs, support_spans
from footfall.report.spreads import GroupedSpread, Spread
from footfall.report.stretch import (
    Delay,
    PlayedPhase,
    ScheduleReport,
    Stretch,
    measure_schedule,
)
from footfall.report.summary import MethodReport, measure
from footfall.report.table import METHODS, text_table
from footfall.report.trace import SurfaceHeights, Trace
from footfall.report.track import RATE, Track, carrying

__all__ = [
    "METHODS",
    "RATE",
    "Delay",
    "Group",
    "GroupedSpread",
    "MethodReport",
    "Mismatch",
    "PlayedPhase",
    "Pops",
    "ScheduleReport",
    "SourceSlips",
    "Span",
    "SpanMeasure",
    "Spread",
    "Stretch",
    "SurfaceHeights",
    "Trace",
    "Track",
    "carried_steps",
    "carrying",
    "clip_trace",
    "joint_pops",
    "mean_source_slips",
    "measure",
    "measure_schedule",
    "measure_spans",
    "performance_trace",
    "played_phases",
    "recording_trace",
    "runs",
    "skating_ratio",
    "support_mismatch",
    "support_spans",
    "text_table",
    "weighted_skate",
]
