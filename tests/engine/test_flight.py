"""What happens while nothing touches the ground (S-27)."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats
from footfall.engine import Recorder, Recording
from footfall.engine.flight import Flight
from footfall.errors import ArgumentError

FPS = 60
GRAVITY = 9.81

Cues = dict[int, str]


def play(names: tuple[str, ...], cues: Cues, flight: Flight, frames: int) -> Recording:
    clips = [ff.sample(name) for name in names]
    hero = ff.Character(clips[0][0].skeleton, flight=flight)
    for name, (clip, supports) in zip(names, clips, strict=True):
        hero.add(name, clip, supports)
    recorder = Recorder(hero, FPS)
    for frame in range(frames):
        if frame in cues:
            hero.start(cues[frame])
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish()


def falls(recording: Recording) -> Floats:
    """Return the downward acceleration of the pelvis within flights, over g, (frames,)."""
    text = recording.support_text
    fall = -np.diff(recording.world_positions[:, 0, 1], 2) * FPS * FPS / GRAVITY
    inner = [i for i in range(1, len(fall)) if text[i - 1 : i + 3] == "----"]
    assert inner
    return np.array([fall[i] for i in inner])


CASES: dict[str, tuple[tuple[str, ...], Cues, int]] = {
    "run": (("run",), {0: "run"}, 200),
    "jump": (("jump",), {0: "jump"}, 110),
    "walk and run": (("walk", "run"), {0: "walk", 40: "run"}, 260),
    "walk and jump": (("walk", "jump"), {0: "walk", 40: "jump"}, 200),
    "run and hop": (("run", "hop-right"), {0: "run", 40: "hop-right"}, 260),
}


@requirement(114, "controlling the parabolic trajectory of the root during the jump")
@pytest.mark.parametrize("case", CASES)
def test_a_ballistic_body_falls_with_g_within_five_percent(case: str) -> None:
    names, cues, frames = CASES[case]
    fall = falls(play(names, cues, "ballistic", frames))
    assert np.abs(fall - 1.0).max() < 0.05


def test_a_mixed_flight_that_is_played_as_it_is_hangs_in_the_air() -> None:
    names, cues, frames = CASES["walk and run"]
    assert np.median(falls(play(names, cues, "played", frames))) < 0.7


def test_free_fall_neither_kicks_nor_catches_the_body() -> None:
    for names, cues, frames in CASES.values():
        greatest = [
            np.linalg.norm(
                np.diff(play(names, cues, flight, frames).world_positions, 2, axis=0), axis=-1
            ).max()
            for flight in ("played", "ballistic")
        ]
        assert greatest[1] < 1.5 * greatest[0]


@requirement(
    113, "One solution can be to freeze the weights associated to the action during a jump phase."
)
def test_frozen_weights_stay_what_they_were_at_take_off() -> None:
    names, cues, frames = CASES["walk and jump"]
    for flight in ("frozen", "ballistic"):
        recording = play(names, cues, flight, frames)
        flying = np.array([symbol == "-" for symbol in recording.support_text])
        inside = flying[1:] & flying[:-1]
        change = np.abs(np.diff(recording.shares, axis=0)).max(axis=1)
        assert change[inside].max() < 1e-12
        assert change.max() > 0.0


def test_another_flight_is_told() -> None:
    with pytest.raises(ArgumentError) as caught:
        play(("run",), {0: "run"}, "floating", 1)  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == "no flight 'floating'; there are played, frozen, ballistic"
