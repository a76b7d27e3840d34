"""Starts that wait: the reason, the expected moment, patience, and going on muted."""

from __future__ import annotations

import pytest

import footfall as ff
from footfall.engine import Started
from footfall.engine.record import SEATS
from footfall.engine.state import LEAVING, RUNNING
from footfall.errors import ArgumentError


def performer(*names: str) -> ff.Character:
    clips = [ff.sample(name) for name in names]
    hero = ff.Character(clips[0][0].skeleton)
    for name, (clip, supports) in zip(names, clips, strict=True):
        hero.add(name, clip, supports)
    return hero


def wait_until_started(hero: ff.Character, name: str) -> float:
    while hero.is_waiting(name):
        hero.advance(1 / 120)
    return float(hero.crowd.characters[0]["clock"])


def test_a_wait_has_a_reason_and_a_moment() -> None:
    hero = performer("walk", "shot")
    hero.start("walk")
    hero.advance(0.1)
    answer = hero.start("shot")
    assert isinstance(answer, ff.Waiting)
    assert not isinstance(answer, ff.Impossible)
    assert answer.until is not None
    wait = answer.until - 0.1
    assert answer.reason == (
        f"waits for 'walk' R→D, {wait:.2f} s: L of 'shot' conflicts with R of 'walk'"
    )
    assert wait_until_started(hero, "shot") == pytest.approx(answer.until, abs=1 / 100)


def test_right_hop_and_left_hop_are_proved_impossible() -> None:
    hero = performer("hop-right", "hop-left")
    hero.start("hop-right")
    hero.advance(0.1)
    answer = hero.start("hop-left")
    assert isinstance(answer, ff.Impossible)
    assert answer.until is None
    assert answer.reason.startswith(
        "impossible beside 'hop-right': in none of their 4 joint phases does anything touch the "
        "ground; "
    )
    hero.stop("hop-left")
    assert not hero.is_active("hop-left")


def test_a_start_gives_up_when_its_patience_is_over() -> None:
    hero = performer("hop-right", "hop-left")
    hero.start("hop-right")
    hero.advance(0.1)
    hero.start("hop-left", patience=0.5)
    hero.advance(0.49)
    assert hero.is_waiting("hop-left")
    hero.advance(0.02)
    assert not hero.is_active("hop-left")


def test_or_goes_on_muted_and_gets_its_legs_back_when_there_is_room() -> None:
    hero = performer("hop-right", "hop-left")
    hero.start("hop-right")
    hero.advance(0.1)
    hero.start("hop-left", patience=0.2, late="mute")
    me = hero.crowd.characters[0]
    for _ in range(120):
        hero.advance(1 / 60)
    seat = int((me["action"] == 1).argmax())
    assert me["muted"][seat]
    assert me["rate"][seat] == 1.0
    assert me["weights"][seat, 0] == 0.0
    assert me["weights"][seat, 1] > 0.0
    hero.stop("hop-right")
    for _ in range(240):
        hero.advance(1 / 60)
    assert me["status"][seat] != LEAVING
    assert not me["muted"][seat]
    assert me["weights"][seat, 0] == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"patience": -1.0}, "a patience of -1.0 s; it must be at least 0"),
        ({"late": "never"}, 'late is \'never\'; it must be "give up" or "mute"'),
    ],
)
def test_wrong_patience_is_explained(options: dict[str, object], message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        performer("walk").start("walk", **options)  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == message


def test_who_has_left_the_schedule_enters_it_anew_when_started_again() -> None:
    restarted = 0
    for moment in range(40):
        hero = performer("walk", "walk-fast")
        hero.start("walk")
        hero.start("walk-fast")
        hero.advance(1.0)
        for _ in range(moment):
            hero.advance(1 / 60)
        hero.stop("walk-fast")
        me = hero.crowd.characters[0]
        while (me["status"] == LEAVING).any() and me["playing"].sum() == 2:
            hero.advance(1 / 60)
        if not (me["status"] == LEAVING).any():
            continue
        restarted += 1
        assert isinstance(hero.start("walk-fast"), Started)
        runs = me["status"] == RUNNING
        for _ in range(60):
            hero.advance(1 / 60)
            runs = (me["status"] == RUNNING) & (me["weights"][:SEATS, 0] > 0.05)
            assert (me["playing"][runs] != 0).all()
        assert runs.sum() == 2
    assert restarted > 0
