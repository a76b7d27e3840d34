"""Does the support contract survive? One row a support span: drift, penetration, float, reach."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.report.slip import measure_spans
from footfall.report.summary import MILLIMETERS
from footfall.report.trace import Trace
from footfall.report.track import RATE, Track
from footfall.skeleton import Skeleton, leg_length

__all__ = ["SpanContract", "contract_of", "contract_table"]


@dataclass(frozen=True, slots=True)
class SpanContract:
    """How one foot kept its place during one support span; lengths in millimeters."""

    foot: int
    """0 for the left foot, 1 for the right."""

    start: float
    """When it begins [s]."""

    end: float
    """When it ends [s]."""

    drift: float
    """Greatest distance of the carrying point from where it was planted, without 67 ms at each
    end; of the whole span where it is shorter than that [mm]."""

    penetration: float
    """95th percentile of how far its lowest point is under its level at rest [mm]."""

    floating: float
    """The same over it [mm]."""

    reach: float
    """Greatest extension of the leg: 1 is straight."""


def contract_of(trace: Trace, skeleton: Skeleton) -> tuple[SpanContract, ...]:
    """Return how every support span of a motion was kept.

    Args:
        trace: The motion and what was commanded.
        skeleton: The body that performs it.
    """
    track = Track.from_trace(trace)
    rows: list[SpanContract] = []
    for of in measure_spans(track):
        span = of.span
        leg = trace.anatomy.legs[span.foot]
        length = max(leg_length(skeleton, leg), 1e-9)
        apart = track.joints[span.start : span.stop, leg.hip]
        apart = apart - track.joints[span.start : span.stop, leg.ankle]
        drift = of.drift if of.inner_drift is None else of.inner_drift
        below, above = np.percentile(of.clearances, [5.0, 95.0]).tolist()
        rows.append(
            SpanContract(
                span.foot,
                span.start / RATE,
                span.stop / RATE,
                MILLIMETERS * drift,
                MILLIMETERS * max(0.0, -below),
                MILLIMETERS * max(0.0, above),
                float(np.linalg.norm(apart, axis=-1).max()) / length,
            )
        )
    return tuple(rows)


def contract_table(rows: tuple[SpanContract, ...]) -> str:
    """Lay out the spans of a contract, one a line, and the 95th percentiles under them."""
    if not rows:
        return "no foot carries: there is no contract to keep"
    lines = ["foot   from s    to s  drift mm  penetration mm  float mm  reach"]
    lines += [
        f"{('left', 'right')[row.foot]:<6}{row.start:7.2f}{row.end:8.2f}{row.drift:10.1f}"
        f"{row.penetration:16.1f}{row.floating:10.1f}{row.reach:7.3f}"
        for row in rows
    ]
    figures = [(row.drift, row.penetration, row.floating, row.reach) for row in rows]
    drift, penetration, floating, reach = np.percentile(np.array(figures), 95.0, axis=0).tolist()
    lines.append(f"{'p95':<21}{drift:10.1f}{penetration:16.1f}{floating:10.1f}{reach:7.3f}")
    return "\n".join(lines)
