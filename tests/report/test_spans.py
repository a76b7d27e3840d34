from __future__ import annotations

from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from tests.report.bodies import resting_feet, supports, trace_of

from footfall.report import Group, Span, Track, carrying, runs, support_spans
from footfall.support import Support


def spans_of(text: str, **more: Any) -> list[tuple[int, int, int, Group]]:
    track = Track.from_trace(trace_of(resting_feet(len(text)), text, **more))
    return [(span.foot, span.start, span.stop, span.group) for span in support_spans(track)]


def test_a_span_is_a_maximal_run_of_frames_in_which_a_foot_carries() -> None:
    assert spans_of("LLDDRR--DD") == [
        (0, 0, 4, Group.ALONE),
        (0, 8, 10, Group.ALONE),
        (1, 2, 6, Group.ALONE),
        (1, 8, 10, Group.ALONE),
    ]


def test_where_no_foot_is_to_carry_there_is_no_span() -> None:
    assert spans_of("-----") == []


@pytest.mark.parametrize("support", list(Support))
def test_the_feet_that_carry_are_those_of_the_algebra(support: Support) -> None:
    assert carrying(np.array([support])).tolist() == [[support.left, support.right]]


def test_a_span_during_which_weights_move_is_a_transition() -> None:
    shares = np.array([[1.0, 0.0]] * 3 + [[0.5, 0.5]] + [[0.0, 1.0]] * 3 + [[0.0, 1.0]] * 4)
    assert spans_of("LLLLLLL-RRR", shares=shares) == [
        (0, 0, 7, Group.TRANSITIONS),
        (1, 8, 11, Group.ALONE),
    ]


def test_a_span_with_lasting_weights_of_two_actions_is_a_mix() -> None:
    assert spans_of("LLLL", shares=np.full((4, 2), 0.5)) == [(0, 0, 4, Group.MIXES)]


def test_given_flags_decide_whether_weights_move() -> None:
    shares = np.full((4, 2), 0.5)
    moving = np.array([False, False, True, False])
    assert spans_of("LLLL", shares=shares, moving=moving) == [(0, 0, 4, Group.TRANSITIONS)]


def test_one_action_must_have_all_the_weight_throughout_to_be_alone() -> None:
    shares = np.array([[1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 1.0]])
    still = np.zeros(4, dtype=np.bool_)
    assert spans_of("LLLL", shares=shares, moving=still) == [(0, 0, 4, Group.MIXES)]


def test_the_inner_part_leaves_out_four_frames_at_each_end() -> None:
    assert Span(0, 10, 30, Group.ALONE).inner == (14, 26)


@pytest.mark.parametrize("flags", list(product([False, True], repeat=6)))
def test_runs_hold_exactly_the_true_flags(flags: tuple[bool, ...]) -> None:
    found = runs(np.array(flags))
    covered = [any(start <= frame < stop for start, stop in found) for frame in range(6)]
    assert covered == list(flags)
    assert all(one[1] < other[0] for one, other in pairwise(found))


def test_the_schedule_of_a_motion_at_30_fps_has_the_same_seconds() -> None:
    text = "LLLLDDRRRR"
    slow = Track.from_trace(trace_of(resting_feet(10), text, fps=30.0))
    assert "".join(Support(int(s)).symbol for s in slow.supports) == "LLLLLLLDDDDRRRRRRRR"
    assert (supports("LD") == [Support.LEFT, Support.DOUBLE]).all()
