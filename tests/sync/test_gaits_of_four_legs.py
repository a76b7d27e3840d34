"""A dog's walk, trot and gallop, made by us: four limbs in the same algebra and planner."""

from __future__ import annotations

from itertools import permutations

import pytest
from tests.paper.requirements import requirement

from footfall.errors import ArgumentError
from footfall.samples import quadruped_supports
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer

# Left and right hind legs are L and R, left and right front legs l and r.
WALK, TROT, GALLOP = (str(quadruped_supports(name)) for name in ("walk", "trot", "gallop"))
CRAWL = "D+lr.3 L+lr.25 D+lr.3 R+lr.25*"
GAITS = {"walk": WALK, "trot": TROT, "gallop": GALLOP, "crawl": CRAWL}


@pytest.mark.parametrize("gait", GAITS.values())
def test_a_gait_alone_is_played_as_it_is(gait: str) -> None:
    sequence = SupportSequence.parse(gait)
    synchronizer = Synchronizer([sequence])
    assert synchronizer.start(0)
    results = [synchronizer.result, *(synchronizer.next_slot() for _ in sequence.phases[1:])]
    assert results == [phase.support for phase in sequence.phases]


@requirement(
    119,
    "limited to bipedic humans. It could be possible (mathematicaly) to extend the algorithm "
    "(considering hands for example)",
)
@pytest.mark.parametrize(("one", "other"), list(permutations(GAITS, 2)))
def test_two_gaits_go_together_and_what_carries_is_what_both_stand_on(one: str, other: str) -> None:
    sequences = [SupportSequence.parse(GAITS[name]) for name in (one, other)]
    synchronizer = Synchronizer(sequences, [0.7, 0.3], names=[one, other])
    synchronizer.start(0)
    synchronizer.start(1)
    for _ in range(60):
        assert synchronizer.next_slot() is not Support.CONFLICT
        supports = [
            row.supports[0]
            for row, muted in zip(
                synchronizer.schedule.rows,
                (action in synchronizer.muted for action in synchronizer.playing),
                strict=True,
            )
            if not muted
        ]
        combined = supports[0]
        for support in supports:
            assert combined is not None
            assert support is not None
            combined &= support
        assert synchronizer.result is combined
    assert 1 in synchronizer.playing or synchronizer.foresee(1) is not None


def test_walk_and_trot_share_their_diagonals() -> None:
    sequences = [SupportSequence.parse(text) for text in (WALK, TROT)]
    synchronizer = Synchronizer(sequences, [0.7, 0.3])
    synchronizer.start(0)
    synchronizer.start(1)
    results = {synchronizer.next_slot().symbol for _ in range(40)}
    assert {"L+r", "R+l"} <= results


def test_the_rule_of_the_paper_knows_two_feet() -> None:
    with pytest.raises(ArgumentError) as caught:
        Synchronizer([SupportSequence.parse(TROT)], planner="paper")
    assert str(caught.value) == (
        "sequence 0 stands on L+r; the rule of the paper knows two feet, R L D and -, "
        'and the planner "footfall" any limbs'
    )
