"""What other methods need and this one must not (section 2)."""

from __future__ import annotations

import time
from itertools import permutations
from typing import Any

import numpy as np
import pytest
from tests.engine.test_pipeline import CUES, FPS, accelerations, play, walker
from tests.paper.requirements import requirement

import footfall as ff
from footfall.engine import library_body as library_module
from footfall.engine.recording import Recording
from footfall.samples import sample_names
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer

LONGEST_WAIT = 24
"""Slots."""


@requirement(
    15,
    "The main limitation of such studies is that motions have to be periodic and of the same kind",
)
@requirement(
    16,
    "The drawback of such methods is that motions must be similar regarding dynamic information.",
)
@requirement(
    92,
    "several applications using usual motions (walks and runs) and specific ones (sports motions,"
    " dance)",
)
def test_any_two_motions_whatever_their_kinds_are_synchronized() -> None:
    sequences = {name: ff.sample(name)[1] for name in sample_names()}
    assert {sequence.cyclic for sequence in sequences.values()} == {True, False}
    never: set[tuple[str, str]] = set()
    for one, other in permutations(sequences, 2):
        synchronizer = Synchronizer([sequences[one], sequences[other]])
        synchronizer.start(0)
        synchronizer.start(1)
        while synchronizer.waiting and synchronizer.slot < LONGEST_WAIT:
            assert synchronizer.next_slot() is not Support.CONFLICT
        if synchronizer.waiting:
            never.add((one, other))
        assert Support.CONFLICT not in synchronizer.schedule.results
    assert never == {("hop-right", "hop-left"), ("hop-left", "hop-right")}


@requirement(18, "lack of interactivity since complete motions are needed")
@requirement(110, "it only synchronizes a limited number of its elements")
@pytest.mark.parametrize("lookahead", [1, 2, 3])
def test_what_lies_beyond_the_look_ahead_is_not_looked_at(lookahead: int) -> None:
    tails = ("R - L -", "L - R D", "- R - L")
    seen: set[str] = set()
    for tail in tails:
        # A start examines the columns k to k + nk + 1: as many phases are the same.
        known = " ".join("RDLDR"[: lookahead + 2])
        joined = f"{known} {tail if not known.endswith(tail[0]) else 'D ' + tail}"
        synchronizer = Synchronizer(
            [SupportSequence.parse("D R D L*"), SupportSequence.parse(joined)],
            planner="paper",
            lookahead=lookahead,
        )
        assert synchronizer.start(0)
        assert synchronizer.start(1)
        seen.add(str(synchronizer.schedule))
    assert len(seen) == 1


@requirement(
    19,
    "adding motions in the database requires the computation of the set of all the possible "
    "transitions with the other motions",
)
def test_adding_a_clip_touches_no_other_and_costs_no_more_in_a_large_library(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    packed: list[str] = []
    pack = library_module.pack_clip

    def counted(*arguments: Any) -> Any:
        packed.append("clip")
        return pack(*arguments)

    monkeypatch.setattr(library_module, "pack_clip", counted)
    library = ff.MotionLibrary()
    for number in range(12):
        before = library.actions
        kept = [(one, one.packed.keys.tobytes(), one.packed.roots.tobytes()) for one in before]
        library.add(f"walk {number}", *ff.sample("walk" if number % 2 else "run"))
        assert len(packed) == number + 1
        assert library.actions[:-1] == before
        for action, (one, keys, roots) in zip(library.actions, kept, strict=False):
            assert action is one
            assert (one.packed.keys.tobytes(), one.packed.roots.tobytes()) == (keys, roots)


def test_nor_does_it_change_what_is_being_played() -> None:
    alone, joined = walker(), walker()
    for hero in (alone, joined):
        play(hero, CUES, 120)
    joined.add("kick", *ff.sample("kick"))
    for _ in range(60):
        one = alone.advance(1 / FPS).world_positions.copy()
        assert np.array_equal(joined.advance(1 / FPS).world_positions, one)


@requirement(20, "they are not suitable for crowd animations either")
def test_a_hundred_characters_take_less_than_a_frame() -> None:
    crowd = ff.Crowd(walker().library, 100)
    crowd.start(0)
    for frame in range(40):
        crowd.start(1, [frame])
        crowd.advance(1 / FPS)
    begun = time.process_time()
    for _ in range(20):
        crowd.advance(1 / FPS)
    assert (time.process_time() - begun) / 20 < 1.0 / FPS


@requirement(
    21, "the support constraints for one leg is like a boolean: a leg is supporting the body or not"
)
@pytest.mark.parametrize("priorities", [(0.99, 0.01), (0.51, 0.49), (7.0, 0.5)])
def test_how_much_an_action_weighs_does_not_weaken_its_support(
    priorities: tuple[float, float],
) -> None:
    walks = [SupportSequence.parse("R D L D*"), SupportSequence.parse("D R - L*")]
    synchronizer = Synchronizer(walks, priorities, planner="paper")
    synchronizer.start(0)
    synchronizer.start(1)
    for _ in range(12):
        synchronizer.next_slot()
    trace = synchronizer.trace
    assert " ".join(result.symbol for result in trace.results) == "R R - L R R - L R R - L R"
    for column, result in enumerate(trace.results):
        one, other = (row.supports[column] for row in trace.rows)
        assert one is not None
        assert other is not None
        assert one & other is result


@requirement(22, "offers an intermediate solution that ensures continuity")
def test_a_mix_of_a_slow_and_a_fast_walk_goes_at_a_speed_between_and_without_a_jump() -> None:
    def recorded(*names: str) -> Recording:
        hero = ff.Character(ff.sample("walk")[0].skeleton, footprints=False)
        for name in names:
            hero.add(name, *ff.sample(name))
        return play(hero, {0: ("start", names[0]), 1: ("start", names[-1])}, 240)

    def speed(recording: Recording) -> float:
        way = recording.world_positions[-1, 0] - recording.world_positions[120, 0]
        return float(np.linalg.norm(way)) / (119 / FPS)

    slow, fast = recorded("walk-slow"), recorded("walk-fast")
    mixed = recorded("walk-slow", "walk-fast")
    margin = (speed(fast) - speed(slow)) / 6.0
    assert speed(slow) + margin < speed(mixed) < speed(fast) - margin
    greatest = max(accelerations(one.world_positions).max() for one in (slow, fast))
    assert accelerations(mixed.world_positions).max() < 1.5 * greatest
