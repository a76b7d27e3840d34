from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from footfall.arrays import Floats
from footfall.timing import normalize_weights, slot_duration
from footfall.timing.weights import LONE

SEATS, PARTS = 4, 5


def weights(priorities: object, levels: object) -> Floats:
    priorities = np.asarray(priorities, dtype=np.float64)
    out = np.full((len(priorities) + 1, priorities.shape[1]), np.nan)
    normalize_weights(priorities, np.asarray(levels, dtype=np.float64), out)
    return out


some_priorities = arrays(
    np.float64, (SEATS, PARTS), elements=st.one_of(st.just(0.0), st.floats(1e-3, 1e3))
)
some_levels = arrays(
    np.float64, (SEATS,), elements=st.one_of(st.just(0.0), st.just(1.0), st.floats(0.0, 1.0))
)


@settings(deadline=None)
@given(some_priorities, some_levels)
def test_shares_are_never_negative_and_sum_to_one(priorities: Floats, levels: Floats) -> None:
    shares = weights(priorities, levels)
    assert shares.min() >= 0.0
    np.testing.assert_allclose(shares.sum(axis=0), 1.0, rtol=0, atol=1e-14)


@settings(deadline=None)
@given(st.floats(1e-6, 1e6))
def test_a_lone_action_at_full_level_has_exactly_all(priority: float) -> None:
    assert weights([[priority], [3.0]], [1.0, 0.0]).tolist() == [[1.0], [0.0], [0.0]]


def test_actions_at_full_level_share_by_priority() -> None:
    assert weights([[3.0], [1.0]], [1.0, 1.0]).tolist() == [[0.75], [0.25], [0.0]]


def test_each_body_part_has_priorities_of_its_own() -> None:
    shares = weights([[1.0, 1.0, 0.0], [0.0, 3.0, 0.0]], [1.0, 1.0])
    assert shares.tolist() == [[1.0, 0.25, 0.0], [0.0, 0.75, 0.0], [0.0, 0.0, 1.0]]


def test_what_nobody_takes_is_the_neutral_motions() -> None:
    assert weights([[1.0], [2.0]], [0.0, 0.0]).tolist() == [[0.0], [0.0], [1.0]]
    assert weights([[9.0]], [0.25]).tolist() == [[0.25], [0.75]]
    assert weights(np.zeros((2, 1)), [1.0, 1.0]).tolist() == [[0.0], [0.0], [1.0]]
    assert weights(np.zeros((0, 2)), np.zeros(0)).tolist() == [[1.0, 1.0]]


def test_a_share_too_small_for_a_number_is_the_neutral_motions() -> None:
    assert weights([[5e-324]], [0.25]).tolist() == [[0.0], [1.0]]


@settings(deadline=None)
@given(some_priorities, some_levels, st.sampled_from([0.125, 8.0, 1024.0]))
@example(np.array([[1.0], [1.0]]), np.array([0.5, 0.001]), 1024.0)
def test_only_the_ratio_of_priorities_counts(
    priorities: Floats, levels: Floats, scale: float
) -> None:
    shares = weights(scale * priorities, levels)
    np.testing.assert_allclose(shares, weights(priorities, levels), rtol=0, atol=1e-14)


@settings(deadline=None)
@given(some_priorities, some_levels)
def test_without_level_or_priority_there_is_exactly_no_weight(
    priorities: Floats, levels: Floats
) -> None:
    shares = weights(priorities, levels)[:-1]
    assert not shares[(priorities == 0.0) | (levels[:, np.newaxis] == 0.0)].any()


@settings(deadline=None)
@given(some_priorities, some_levels)
def test_the_neutral_motion_shows_only_while_levels_do_not_add_up_to_one(
    priorities: Floats, levels: Floats
) -> None:
    neutral = weights(priorities, levels)[-1]
    presence = np.where(priorities > 0.0, levels[:, np.newaxis], 0.0).sum(axis=0)
    np.testing.assert_allclose(neutral, np.maximum(0.0, 1.0 - presence), rtol=0, atol=1e-15)


@settings(deadline=None)
@given(some_priorities, some_levels, st.integers(0, SEATS - 1))
def test_nothing_jumps_when_an_action_begins_at_level_zero(
    priorities: Floats, levels: Floats, seat: int
) -> None:
    # The others are either absent or well above zero: a share of a sum that is itself next to
    # nothing changes fast, though by no more than that sum.
    before = np.where(levels < 0.01, 0.0, levels)
    before[seat] = 0.0
    after = before.copy()
    after[seat] = 1e-12
    change = np.abs(weights(priorities, after) - weights(priorities, before))
    assert change.max() < 1e-12 * 1e6 * 1e2 * 2.0


@settings(deadline=None)
@given(st.floats(0.0, 1.0), st.floats(1e-2, 1e2))
def test_a_cross_fade_of_equals_is_linear_in_the_levels(level: float, priority: float) -> None:
    shares = weights([[priority], [priority]], [1.0 - level, level])
    # Near its ends it is still gentler.
    exactly = 1e-14 if LONE <= level <= 1.0 - LONE else 0.015
    np.testing.assert_allclose(shares[:, 0], [1.0 - level, level, 0.0], rtol=0, atol=exactly)


@settings(deadline=None)
@given(st.floats(0.0, 1.0), st.floats(0.4, 4.0), st.floats(0.4, 4.0))
def test_a_fade_beside_others_is_linear_in_its_level_whatever_the_priorities(
    level: float, priority: float, other: float
) -> None:
    whole = priority / (priority + other)
    share = weights([[priority], [other]], [level, 1.0])[0, 0]
    assert share == pytest.approx(whole * level, abs=1e-14)


def test_only_the_voters_are_counted() -> None:
    shares = np.array([1.0, 3.0, 9.0])
    durations = np.array([2.0, 4.0, 1000.0])
    assert slot_duration(shares, durations, 2) == 3.5


def test_where_no_voter_has_weight_the_plain_mean_is_taken() -> None:
    assert slot_duration(np.zeros(3), np.array([1.0, 2.0, 9.0]), 2) == 1.5


@settings(deadline=None)
@given(
    arrays(np.float64, (6,), elements=st.one_of(st.just(0.0), st.floats(1e-6, 1.0))),
    arrays(np.float64, (6,), elements=st.floats(0.01, 10.0)),
    st.integers(1, 6),
)
def test_a_slot_lasts_between_its_shortest_and_its_longest_phase(
    shares: Floats, durations: Floats, count: int
) -> None:
    result = slot_duration(shares, durations, count)
    voters = durations[:count]
    assert voters.min() * (1 - 1e-12) <= result <= voters.max() * (1 + 1e-12)
    if shares[:count].any():
        assert result == pytest.approx(np.average(voters, weights=shares[:count]), rel=1e-12)
