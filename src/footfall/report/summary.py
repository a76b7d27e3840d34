"""The row of a method in the table that convinces a user (measures, section 3)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from footfall.arrays import Flags, Floats
from footfall.report.comparisons import skating_ratio, weighted_skate
from footfall.report.mismatch import Mismatch, support_mismatch
from footfall.report.pops import Pops, joint_pops
from footfall.report.slip import SpanMeasure, measure_spans
from footfall.report.spans import Group
from footfall.report.spreads import GroupedSpread, rounded
from footfall.report.trace import Trace
from footfall.report.track import RATE, Track, resampled_labels

__all__ = ["MethodReport", "measure"]

MILLIMETERS = 1000.0
"""In a meter."""

HEEL, TOE = 0, 1
"""Which of a foot's points."""


@dataclass(frozen=True, slots=True)
class MethodReport:
    """Everything measured of one motion; lengths in millimeters."""

    slip: GroupedSpread
    """Inner slip of the spans [mm] (measures, section 1): bounds are on this one. Spans shorter
    than twice 67 ms have none."""

    whole_slip: GroupedSpread
    """The same with the edges of the spans [mm]."""

    excess: GroupedSpread
    """Inner slip minus that of the source clips in the same phases [mm]; of no span where the
    sources are not known."""

    drift: GroupedSpread
    """Inner drift of the spans [mm]: greatest distance of the carrying point from where it was
    planted."""

    whole_drift: GroupedSpread
    """The same with the edges of the spans [mm]."""

    penetration: GroupedSpread
    """How far the lowest foot point is under the surface, over the frames of the spans [mm]."""

    floating: GroupedSpread
    """How far it is over the surface [mm]."""

    mismatch: Mismatch | None
    """How often the detector disagrees with the schedule; None where it was not run."""

    pops: Pops | None
    """How fast joints move; None below three frames."""

    pop_ratios: Pops | None
    """The same over the figures of the source clips; None where those are not known."""

    weighted_skate: float
    """Exponentially weighted skate at 60 Hz [mm per frame] (OMOMO)."""

    skating_ratio: float | None
    """Share of frames in which a foot skates, at 60 Hz, 0 to 1 (GMD)."""

    def to_json(self) -> dict[str, object]:
        """Return all figures by name; a number that there is none of is None."""
        mismatch = self.mismatch
        return {
            "slip_mm": self.slip.to_json(),
            "slip_whole_mm": self.whole_slip.to_json(),
            "excess_mm": self.excess.to_json(),
            "drift_mm": self.drift.to_json(),
            "drift_whole_mm": self.whole_drift.to_json(),
            "penetration_mm": self.penetration.to_json(),
            "float_mm": self.floating.to_json(),
            "mismatch": None if mismatch is None else rounded(mismatch.overall),
            "mismatch_transitions": None if mismatch is None else rounded(mismatch.transitions),
            "pops": None if self.pops is None else self.pops.to_json(),
            "pop_ratios": None if self.pop_ratios is None else self.pop_ratios.to_json(),
            "weighted_skate_mm": rounded(self.weighted_skate),
            "skating_ratio": rounded(self.skating_ratio),
        }


def measure(
    trace: Trace,
    *,
    contacts: Flags | None = None,
    source_slips: Floats | None = None,
    source_pops: Pops | None = None,
) -> MethodReport:
    """Measure a finished motion.

    Args:
        trace: The motion and what was commanded.
        contacts: Whether a detector finds each foot on the ground in it, shape (frames, 2).
        source_slips: The weighted mean inner slip of the source clips in the same phases [m],
            shape (frames, 2): see `mean_source_slips`.
        source_pops: The figures of the source clips: see `Pops.greatest`.
    """
    track = Track.from_trace(trace)
    sources = None if source_slips is None else resampled_labels(source_slips, trace.fps)
    spans = measure_spans(track, sources)
    mismatch = None
    if contacts is not None:
        detected = resampled_labels(contacts, trace.fps)
        mismatch = support_mismatch(track.supports, detected, track.moving)
    pops = joint_pops(track.joints, track.rates)
    ratios = None if pops is None or source_pops is None else pops.over(source_pops)
    return MethodReport(
        slip=_lengths((of.span.group, of.inner_slip) for of in spans),
        whole_slip=_lengths((of.span.group, of.slip) for of in spans),
        excess=_lengths((of.span.group, of.excess) for of in spans),
        drift=_lengths((of.span.group, of.inner_drift) for of in spans),
        whole_drift=_lengths((of.span.group, of.drift) for of in spans),
        penetration=_lengths(_clearances(spans, below=True)),
        floating=_lengths(_clearances(spans, below=False)),
        mismatch=mismatch,
        pops=pops,
        pop_ratios=ratios,
        weighted_skate=_weighted_skate(track),
        skating_ratio=skating_ratio(track.places[:, :, TOE], track.clearances[:, :, TOE], RATE),
    )


def _lengths(values: Iterable[tuple[Group, float | None]]) -> GroupedSpread:
    known = [(group, MILLIMETERS * value) for group, value in values if value is not None]
    return GroupedSpread.of(known)


def _clearances(spans: Iterable[SpanMeasure], *, below: bool) -> Iterator[tuple[Group, float]]:
    sign = -1.0 if below else 1.0
    for of in spans:
        for clearance in of.clearances.tolist():
            yield of.span.group, max(sign * clearance, 0.0)


def _weighted_skate(track: Track) -> float:
    # The floor is where the toes rest; under the ankle the surface is that under the heel.
    surface = track.points[:, :, HEEL, 1] - track.heights[:, :, HEEL]
    floor = surface + track.resting_levels[:, TOE]
    ankles = track.ankles - track.surface_displacement[:, :, HEEL]
    return weighted_skate(
        ankles[..., [0, 2]],
        track.ankles[..., 1] - floor,
        track.places[:, :, TOE],
        track.clearances[:, :, TOE],
    )
