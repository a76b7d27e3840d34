"""Followers stand between the same two markers as their leader, as far on."""

from __future__ import annotations

import pytest

from footfall.baselines import MarkerLeader, Playing
from footfall.support import SupportSequence

WALK = SupportSequence.parse("R.4 D.1 L.4 D.1*")  # lands left at 0.4, right at 0.9
LIMP = SupportSequence.parse("R.2 D.1 L.6 D.1*")  # left at 0.2, right at 0.9
HOP = SupportSequence.parse("R.3 -.2*")
IDLE = SupportSequence.parse("D4*")
KICK = SupportSequence.parse("D.5 L1 D.5")


def times(*playing: Playing, dt: float = 0.01) -> list[float]:
    return MarkerLeader().clip_times(playing, dt)


def test_the_heaviest_leads_at_its_own_rate() -> None:
    playing = (Playing(WALK, 0.5, 0.3, False), Playing(LIMP, 0.34, 0.7, False))
    led = times(*playing)
    assert led[1] == pytest.approx(0.35)
    # 0.15 of the 0.7 s between the landings, and so of the 0.5 s of the walk.
    assert led[0] == pytest.approx(0.507, abs=1e-3)


def test_a_follower_that_enters_is_put_where_the_leader_is() -> None:
    playing = (Playing(WALK, 2.64, 0.9, False), Playing(LIMP, 0.0, 0.0, True))
    assert times(*playing)[1] == pytest.approx(0.2 + 0.5 * 0.7)


def test_the_newcomer_does_not_lead_before_it_has_entered() -> None:
    playing = (Playing(WALK, 2.64, 0.0, False), Playing(LIMP, 0.0, 1.0, True))
    assert times(*playing)[0] == pytest.approx(2.65)


def test_a_follower_goes_on_over_the_end_of_its_cycle() -> None:
    playing = (Playing(WALK, 0.895, 1.0, False), Playing(LIMP, 3.895, 0.0, False))
    assert times(*playing)[1] == pytest.approx(3.903, abs=2e-3)


def test_feet_that_land_in_one_only_are_no_markers() -> None:
    # From one right landing to the next: half of the walk is half of the hop.
    playing = (Playing(WALK, 1.39, 1.0, False), Playing(HOP, 0.0, 0.0, True))
    assert times(*playing)[1] == pytest.approx(0.25)


def test_without_common_markers_the_share_of_the_cycle_counts() -> None:
    playing = (Playing(WALK, 0.24, 1.0, False), Playing(IDLE, 0.0, 0.0, True))
    assert times(*playing)[1] == pytest.approx(1.0)


def test_what_is_played_once_stays_outside_the_group() -> None:
    playing = (Playing(KICK, 0.3, 0.9, False), Playing(WALK, 0.2, 0.1, False))
    assert times(*playing) == pytest.approx([0.31, 0.21])


def test_nothing_playing_is_nothing() -> None:
    assert times() == []
