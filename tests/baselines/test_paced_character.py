"""Somebody else's clip times on our engine."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from footfall.baselines import EqualCycles, MarkerLeader, PacedCharacter, Pacing, Playing
from footfall.engine import Character
from footfall.samples import sample
from footfall.skeleton import find_anatomy


class OwnSpeed:
    """Every clip at its own speed: a plain cross-fade."""

    def clip_times(self, playing: Sequence[Playing], dt: float) -> list[float]:
        return [one.clip_time + dt for one in playing]


def added(character: Character) -> Character:
    for name, priority in (("walk", 1.0), ("run", 2.0)):
        character.add(name, *sample(name), priority=priority)
    character.start("walk")
    return character


def paced(pacing: Pacing) -> Character:
    return added(PacedCharacter(sample("walk")[0].skeleton, pacing))


def test_clips_at_their_own_speed_give_the_bits_of_a_cross_fade() -> None:
    theirs = paced(OwnSpeed())
    ours = added(Character(sample("walk")[0].skeleton, synchronized=False))
    for frame in range(120):
        if frame == 50:
            theirs.start("run")
            ours.start("run")
        one, other = theirs.advance(1 / 60), ours.advance(1 / 60)
        np.testing.assert_allclose(one.world_positions, other.world_positions, atol=1e-9)


@pytest.mark.parametrize("pacing", [EqualCycles(), MarkerLeader()])
def test_a_run_beside_a_walk_lands_on_the_same_foot(pacing: Pacing) -> None:
    character = paced(pacing)
    for _ in range(37):
        character.advance(1 / 60)
    character.start("run")
    agreed = 0
    for _ in range(120):
        character.advance(1 / 60)
        me = character.crowd.characters[0]
        walks, runs = (
            sample(name)[1].support_at(float(me["clip_time"][seat]))
            for seat, name in enumerate(("walk", "run"))
        )
        agreed += (walks & runs).name != "CONFLICT"
    assert agreed >= 115


def test_a_long_advance_is_cut_and_no_time_at_all_passes_none() -> None:
    one, other = paced(EqualCycles()), paced(EqualCycles())
    one.advance(0.2)
    for _ in range(6):
        other.advance(0.2 / 6)
    ankle = find_anatomy(one.skeleton).left.ankle
    np.testing.assert_allclose(
        one.crowd.world_positions[0, ankle], other.crowd.world_positions[0, ankle], atol=1e-9
    )
    before = float(one.crowd.characters[0]["clip_time"][0])
    one.advance(0.0)
    assert float(one.crowd.characters[0]["clip_time"][0]) == before
