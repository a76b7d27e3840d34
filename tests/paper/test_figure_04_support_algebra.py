"""Figure 4: the relation ⊕, all 25 cells, and the laws that section 4.1 needs (eq. 1 to 3)."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from tests.paper.requirements import requirement

from footfall.support import Support, SupportSequence, combine
from footfall.sync import Synchronizer
from footfall.sync.columns import combine_column
from footfall.sync.tables import SequenceTable, rules_of
from footfall.sync.window import Window

DS, RS, LS = Support.DOUBLE, Support.RIGHT, Support.LEFT
ERR, NO = Support.CONFLICT, Support.FLIGHT

ORDER = (DS, RS, LS, ERR, NO)
FIGURE_4 = (
    (DS, RS, LS, ERR, NO),
    (RS, RS, ERR, ERR, NO),
    (LS, ERR, LS, ERR, NO),
    (ERR, ERR, ERR, ERR, NO),
    (NO, NO, NO, NO, NO),
)


@requirement(36, "The latter is defined as a sequence of elements from the set")
@requirement(37, "is the period of time when the right (resp. left) foot is on the ground")
@requirement(38, "Algebraic relation that determines if motions can be blended.")
@requirement(
    39,
    "is the neutral element because our blending module uses a neutral motion with two feet on "
    "the ground",
)
@requirement(40, "Ø is the absorbing element.")
@requirement(41, "is the absorbing element of the subset")
@requirement(42, "are the elements that are completely incompatible and that set an error")
@pytest.mark.parametrize(("row", "column"), list(product(range(5), repeat=2)))
def test_every_cell_of_the_figure(row: int, column: int) -> None:
    assert ORDER[row] & ORDER[column] is FIGURE_4[row][column]


@requirement(45, "synchronized if and only if")
@pytest.mark.parametrize(("row", "column"), list(product((0, 1, 2, 4), repeat=2)))
def test_the_synchronizer_combines_as_the_figure_says(row: int, column: int) -> None:
    # All but Err, which no clip has.
    texts = [ORDER[row].symbol, ORDER[column].symbol]
    table = SequenceTable.of([SupportSequence.parse(text) for text in texts])
    window = Window.empty(2, 1)
    window.playing[:] = True
    window.sequence[:] = (0, 1)
    window.phases[:, 0] = 0
    playable = combine_column(table, window, rules_of("paper"), 0)
    assert window.results[0] == FIGURE_4[row][column]
    assert playable is (FIGURE_4[row][column] is not ERR)


@requirement(43, "As our relation is commutative, two motions")
@requirement(44, "as our algebraic relation is associative")
# Five elements: try them all instead of sampling them.
@pytest.mark.parametrize(("a", "b", "c"), list(product(Support, repeat=3)))
def test_order_and_grouping_never_matter(a: Support, b: Support, c: Support) -> None:
    assert a & b is b & a
    assert (a & b) & c is a & (b & c)
    assert combine(np.array([a, b, c])) == (a & b) & c


@requirement(
    46,
    "even if only two motions are not synchronizable amongst several others, the relation will "
    "set an error",
)
@pytest.mark.parametrize("others", list(product((DS, RS, LS), repeat=3)))
def test_two_in_conflict_among_many_are_a_conflict_unless_one_flies(
    others: tuple[Support, ...],
) -> None:
    assert combine(np.array([LS, RS, *others])) == ERR
    assert combine(np.array([LS, *others, NO, RS])) == NO


@requirement(
    47,
    "This motion always has the lowest priority and is overridden by any other motion. It is "
    "useful when there is no active motion to play.",
)
@requirement(
    48, "our algebraic relation ensures that its sequence overrides the neutral motion's sequence"
)
def test_a_walk_alone_overrides_the_neutral_motion() -> None:
    synchronizer = Synchronizer([SupportSequence.parse("R D L D*")], planner="paper")
    assert synchronizer.result is DS
    synchronizer.start(0)
    results = [synchronizer.result, *(synchronizer.next_slot() for _ in range(4))]
    assert results == [RS, DS, LS, DS, RS]
    synchronizer.stop(0)
    assert synchronizer.result is DS
