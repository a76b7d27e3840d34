"""Figure 7: whenever each action was started, one index k runs through all of them."""

from __future__ import annotations

from tests.paper.requirements import requirement

from footfall.support import SupportSequence
from footfall.sync import Synchronizer


@requirement(62, "whenever the corresponding actions were started")
def test_the_current_phases_share_one_column() -> None:
    # Top of the figure, three actions started at different moments; bottom, the
    # same three under the index k of the slot being played.
    sequences = [SupportSequence.parse(text) for text in ("R D L D*", "D -", "D L D R*")]
    synchronizer = Synchronizer(
        sequences, names=["one", "two", "three"], planner="paper", lookahead=3
    )
    assert synchronizer.start(0)
    synchronizer.next_slot()
    assert synchronizer.start(1)
    synchronizer.next_slot()
    synchronizer.next_slot()
    assert synchronizer.start(2)
    assert str(synchronizer.trace) == (
        "slot        0    1    2    3\n"
        "one    3    R    D    L    D\n"
        "two    2    .    D    -    -\n"
        "three  1    .    .    .    D\n"
        "blend       R    D    -    -"
    )
    assert str(synchronizer.schedule) == (
        "slot        k    k+1  k+2  k+3\n"
        "one    3    D    R    D    L\n"
        "two    2    -    -    -    -\n"
        "three  1    D    L    D    R\n"
        "blend       -    -    -    -"
    )


@requirement(
    3,
    "It is based on an algebraic relation to detect incompatible motions and to select elements "
    "of the sequence to be enlarged.",
)
def test_a_held_phase_is_marked_and_explained() -> None:
    walk = SupportSequence.parse("D R D L*")
    synchronizer = Synchronizer([walk, walk], names=["walk", "late"], planner="paper", lookahead=4)
    synchronizer.start(0)
    synchronizer.next_slot()
    synchronizer.next_slot()
    synchronizer.start(1)
    assert str(synchronizer.schedule) == (
        "slot        k    k+1  k+2  k+3  k+4\n"
        "walk   2    D    L    D    R    D\n"
        "late   1    D    D~   R    D    L    ~ held: its next phase, R, conflicts with L\n"
        "blend       D    L    R    R    L"
    )
