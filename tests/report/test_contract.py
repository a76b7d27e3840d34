"""The support contract, span by span; arms in the trunk."""

from __future__ import annotations

import numpy as np
from tests.walking_figure import anatomy, skeleton, walk

from footfall.report import clip_trace
from footfall.report.contract import SpanContract, contract_of, contract_table
from footfall.skeleton import find_anatomy
from footfall.skeleton.capsule_overlap import arm_overlaps
from footfall.support import SupportSequence

STANCE = 36
"""Frames at 60 Hz during which the left foot of `walk` is planted."""


def rows(sliding: float) -> tuple[SpanContract, ...]:
    clip = walk(frames=STANCE, sliding=sliding)
    known = SupportSequence.parse(f"L{clip.duration:.6f}", cyclic=False)
    return contract_of(clip_trace(clip, anatomy(), known), clip.skeleton)


def test_a_sliding_foot_is_told_by_its_drift() -> None:
    assert rows(0.3)[0].drift > rows(0.0)[0].drift + 50.0


def test_the_table_has_a_line_a_span_and_the_percentiles() -> None:
    lines = contract_table(rows(0.0)).splitlines()
    assert len(lines) == 3
    assert lines[0] == "foot   from s    to s  drift mm  penetration mm  float mm  reach"
    assert lines[1].startswith("left")
    assert lines[2].startswith("p95")


def test_no_span_is_said_so() -> None:
    assert contract_table(()) == "no foot carries: there is no contract to keep"


def test_an_arm_in_the_trunk_is_told_and_one_beside_it_is_not() -> None:
    clip = walk(frames=3)
    found = find_anatomy(skeleton())
    positions = np.array(clip.world_poses()[1])
    beside = arm_overlaps(skeleton(), found, positions)
    arm = found.arms[0]
    assert arm is not None
    positions[:, arm.wrist] = positions[:, skeleton().index("Chest")]
    inside = arm_overlaps(skeleton(), found, positions)
    assert (inside[:, 0] > beside[:, 0] + 0.05).all()
    assert (inside[:, 1] == beside[:, 1]).all()
