"""Cycles scaled to one length share one normalized time."""

from __future__ import annotations

import pytest

from footfall.baselines import EqualCycles, Playing
from footfall.support import SupportSequence

WALK = SupportSequence.parse("R.4 D.1 L.4 D.1*")  # its left foot lands at 0.4 s
RUN = SupportSequence.parse("L.2 -.15 R.2 -.15*")  # at 0 s
TWO_STRIDES = SupportSequence.parse("R.4 D.1 L.4 D.1 R.4 D.1 L.4 D.1*")
KICK = SupportSequence.parse("D.5 L1 D.5")


def times(*playing: Playing, dt: float = 0.01) -> list[float]:
    return EqualCycles().clip_times(playing, dt)


def test_a_cycle_alone_plays_at_its_own_speed() -> None:
    assert times(Playing(WALK, 3.7, 1.0, False)) == pytest.approx([3.71])
    assert times(Playing(WALK, 3.7, 0.0, False)) == pytest.approx([3.71])


def test_an_entering_cycle_lands_when_the_other_one_does() -> None:
    # The walk is 0.25 of its cycle past its left landing, and so is the run.
    playing = (Playing(WALK, 1.65, 1.0, False), Playing(RUN, 0.0, 0.0, True))
    assert times(*playing) == pytest.approx([1.66, 0.175 + 0.007])


def test_all_cycles_last_the_weighted_mean_of_their_lengths() -> None:
    playing = (Playing(WALK, 0.4, 0.25, False), Playing(RUN, 0.0, 0.75, False))
    share = 0.01 / (0.25 * 1.0 + 0.75 * 0.7)
    assert times(*playing) == pytest.approx([0.4 + share * 1.0, 0.0 + share * 0.7])


def test_a_clip_of_two_strides_is_two_cycles() -> None:
    playing = (Playing(WALK, 0.4, 0.5, False), Playing(TWO_STRIDES, 0.4, 0.5, False))
    assert times(*playing) == pytest.approx([0.41, 0.41])


def test_what_is_played_once_is_not_scaled() -> None:
    playing = (Playing(KICK, 0.3, 0.9, False), Playing(RUN, 0.0, 0.1, False))
    assert times(*playing) == pytest.approx([0.31, 0.01])


def test_a_cycle_in_which_no_left_foot_lands_counts_from_the_right() -> None:
    hop = SupportSequence.parse("-.2 R.3*")
    playing = (Playing(WALK, 0.4, 1.0, False), Playing(hop, 0.0, 0.0, True))
    assert times(*playing)[1] == pytest.approx(0.2 + 0.01 * 0.5)
