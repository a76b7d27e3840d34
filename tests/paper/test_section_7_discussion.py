"""What section 7 says of the method: its cost, its limits, and the rules that soften them."""

from __future__ import annotations

from itertools import pairwise, permutations, product

import numpy as np
import pytest
from tests.engine.test_pipeline import CUES, FPS, play, walker
from tests.paper.requirements import requirement
from tests.sync.strict_sequences import every_strict_text

import footfall as ff
from footfall.report.schedule_play import pairs_of, play_pair
from footfall.report.schedule_score import score_pairs
from footfall.samples import sample_names
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer
from footfall.sync.prices import GREATEST_RATE, LEAST_RATE

SEQUENCES = {
    name: ff.sample(name)[1] for name in ("walk", "run", "hop-right", "hop-left", "shot", "jump")
}


CYCLES = [SupportSequence.parse(text) for text in every_strict_text(4) if text.endswith("*")]

Step = tuple[Support, Support]


def steps_of(sequence: SupportSequence) -> list[Step]:
    """Return each support of a sequence with the one that follows it."""
    phases = (*sequence.phases, *sequence.phases[: 1 if sequence.cyclic else 0])
    return [(one.support, other.support) for one, other in pairwise(phases)]


@requirement(
    108, "Even in this kind of situation, our synchronization technique always finds a solution"
)
def test_every_wait_ends_as_foreseen_or_is_proved_to_be_for_ever() -> None:
    waits = proofs = 0
    for (one, other), slots in product(permutations(SEQUENCES, 2), range(4)):
        synchronizer = Synchronizer([SEQUENCES[one], SEQUENCES[other]], names=[one, other])
        synchronizer.start(0)
        for _ in range(slots):
            synchronizer.next_slot()
        if synchronizer.start(1):
            continue
        refusal = synchronizer.foresee(1)
        assert refusal is not None
        assert refusal.reason
        for _ in range(12):
            synchronizer.next_slot()
        assert (synchronizer.waiting == {}) is not refusal.impossible
        waits += not refusal.impossible
        proofs += refusal.impossible
    assert waits > 3
    assert proofs == 8


@requirement(
    109, "negligible since it only synchronizes sequences when motions change their support phases"
)
def test_nothing_is_decided_while_no_motion_changes_its_support() -> None:
    hero = walker()
    play(hero, CUES, 180)
    me = hero.crowd.characters[0]
    states: list[tuple[int, bytes]] = []
    for _ in range(240):
        hero.advance(1 / FPS)
        states.append((int(me["slot_index"]), me["phases"].tobytes() + me["results"].tobytes()))
    slots = len({slot for slot, _ in states})
    assert slots < 60
    for (slot, decided), (next_slot, decided_next) in pairwise(states):
        assert slot != next_slot or decided == decided_next


@requirement(
    111,
    "nothing ensures that the weighted sum of two motions that both respect dynamics also "
    "respects dynamics",
)
def test_a_weighted_sum_of_two_flights_is_no_parabola() -> None:
    # A limitation: the mean of two motions falls as neither gravity nor they ask for.
    times = np.linspace(0.0, 1.0, 101)
    one, other = -4.905 * times**2 + 3.0 * times, -4.905 * (1.4 * times) ** 2 + 3.0 * 1.4 * times
    falls = np.diff(0.5 * (one + other), n=2) / 0.01**2
    assert falls == pytest.approx(-0.5 * (1.0 + 1.4**2) * 9.81)


@requirement(112, "the time warping technique can engender large dilations of the motion duration")
def test_as_printed_motions_are_dilated_beyond_all_bounds_and_the_planner_bounds_them() -> None:
    pairs = list(pairs_of(SEQUENCES))
    paper, planner = (
        score_pairs(play_pair(*pair, (0.7, 0.3), mode) for pair in pairs)
        for mode in ("paper", "footfall")
    )
    assert paper.percentiles[3] > 1.0 / LEAST_RATE + 0.5
    assert planner.percentiles[3] <= 1.0 / LEAST_RATE + 1e-9
    assert planner.percentiles[0] >= 1.0 / GREATEST_RATE - 1e-9


@requirement(118, "choose best solutions while taking account of time dilatation")
def test_the_solution_chosen_is_the_one_that_dilates_less() -> None:
    pairs = list(pairs_of(SEQUENCES))
    paper, planner = (
        score_pairs(play_pair(*pair, (0.7, 0.3), mode) for pair in pairs)
        for mode in ("paper", "footfall")
    )
    assert planner.cases == paper.cases > 90
    assert planner.octaves < 0.6 * paper.octaves
    assert planner.flight_p95 < paper.flight_p95


@requirement(
    113, "One solution can be to freeze the weights associated to the action during a jump phase."
)
def test_leg_weights_are_frozen_during_a_flight() -> None:
    recording = play(walker(), {0: ("start", "run"), 40: ("start", "walk")}, 200)
    share = recording.shares[:, 0]
    moved = np.abs(np.diff(share)) > 1e-9
    flies = recording.supports == Support.FLIGHT
    assert moved.sum() > 10
    assert flies.sum() > 20
    assert not (moved & flies[1:] & flies[:-1]).any()


@requirement(116, "we directly try to synchronize it without using another transitional one")
def test_no_other_motion_is_ever_put_in_between() -> None:
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    for name in ("walk", "run", "kick", "side-step", "jump"):
        hero.add(name, *ff.sample(name))
    recording = play(hero, {0: ("start", "walk"), 70: ("start", "run")}, 240)
    asked = [recording.actions.index(name) for name in ("walk", "run")]
    others = [i for i in range(len(recording.actions)) if i not in asked]
    assert np.isnan(recording.clip_times[:, others]).all()
    assert not recording.shares[:, others].any()
    # And each plays its own phases one after the other, none left out, none from elsewhere.
    for action in asked:
        phases = recording.phases[:, action]
        steps = np.diff(phases[~np.isnan(phases)])
        assert set(steps) <= {0.0, 1.0}


@requirement(
    93,
    "Common bipedic sequences (including right and left supports) have enough variations to "
    "ensure several solutions",
)
@pytest.mark.parametrize(
    ("sequences", "counted"),
    [
        (CYCLES, 20_736),
        ([ff.sample(name)[1] for name in sample_names()], 448),
    ],
    ids=["every strict cycle of up to four phases", "our samples"],
)
def test_every_conflict_of_two_has_exactly_two_solutions(
    sequences: list[SupportSequence], counted: int
) -> None:
    steps = [step for sequence in sequences for step in steps_of(sequence)]
    conflicts = 0
    for one, other in product(steps, repeat=2):
        together = one[0] & other[0] is not Support.CONFLICT
        if not together or one[1] & other[1] is not Support.CONFLICT:
            continue
        conflicts += 1
        solutions = [
            (first, second)
            for first, second in ((0, 1), (1, 0))
            if one[first] & other[second] is not Support.CONFLICT
        ]
        # One of the two is held, whichever; holding both would only delay.
        assert solutions == [(0, 1), (1, 0)]
    assert conflicts == counted
