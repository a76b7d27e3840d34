"""What viewers are told of a character is what it does."""

from __future__ import annotations

from itertools import pairwise

import pytest

import footfall as ff
from footfall.engine.inspection import planned_slots
from footfall.errors import ArgumentError
from footfall.support import Support


def hero(*names: str) -> ff.Character:
    clips = [ff.sample(name) for name in names]
    character = ff.Character(clips[0][0].skeleton)
    for name, (clip, supports) in zip(names, clips, strict=True):
        character.add(name, clip, supports)
    return character


def test_an_action_that_never_started_is_idle() -> None:
    state = hero("walk").state("walk")
    assert (state.activity, state.phase, state.reason, max(state.weights)) == ("idle", None, "", 0)


def test_an_action_alone_runs_at_its_own_speed_with_all_the_weight() -> None:
    character = hero("walk")
    character.start("walk")
    character.advance(0.1)
    state = character.state("walk")
    assert state.activity == "running"
    assert state.rate == pytest.approx(1.0)
    assert state.weights[0] == pytest.approx(1.0)
    assert state.support is Support(int(character.crowd.supports[0]))
    assert not state.held


def test_a_second_action_fades_in_and_a_stopped_one_fades_out() -> None:
    character = hero("walk", "walk-fast")
    character.start("walk")
    character.advance(0.5)
    character.start("walk-fast")
    character.advance(0.1)
    assert character.state("walk-fast").activity == "fading in"
    character.advance(2.0)
    character.stop("walk")
    character.advance(0.05)
    assert character.state("walk").activity == "fading out"
    assert character.state("walk").progress < 1.0


def test_a_wait_gives_the_reason_that_the_start_gave() -> None:
    character = hero("hop-right", "hop-left")
    character.start("hop-right")
    character.advance(0.4)
    answer = character.start("hop-left")
    assert isinstance(answer, ff.Waiting)
    state = character.state("hop-left")
    assert state.activity == "waiting"
    assert state.reason == answer.reason


def test_planned_slots_follow_each_other_and_the_first_one_is_now() -> None:
    character = hero("walk", "run")
    character.start("walk")
    character.advance(0.7)
    slots = planned_slots(character.crowd)
    assert len(slots) == 6
    assert slots[0].start <= 0.7 <= slots[0].start + slots[0].duration
    for one, other in pairwise(slots):
        assert other.start == pytest.approx(one.start + one.duration)
    assert [slot.result for slot in slots] == list(character.schedule.results)
    assert all(slot.supports[1] is None for slot in slots)


def test_a_plan_comes_true_where_nothing_is_changed() -> None:
    character = hero("walk")
    character.start("walk")
    character.advance(0.3)
    for slot in planned_slots(character.crowd)[1:]:
        middle = slot.start + 0.5 * slot.duration
        character.advance(middle - float(character.crowd.characters[0]["clock"]))
        assert Support(int(character.crowd.supports[0])) is slot.result


def test_who_stands_on_the_ground_is_carried_along_when_it_rises() -> None:
    character, other = hero("walk"), hero("walk")
    for one in (character, other):
        one.start("walk")
        one.advance(0.4)
    character.raise_ground(0.25)
    up = character.advance(0.1).world_positions - other.advance(0.1).world_positions
    assert up[:, 1] == pytest.approx(0.25)
    assert up[:, [0, 2]] == pytest.approx(0.0)
    with pytest.raises(ArgumentError, match="ground at height nan"):
        character.raise_ground(float("nan"))
