"""Figure 4: the relation ⊕, all 25 cells, and the laws that section 4.1 needs (eq. 1 to 3)."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

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


@pytest.mark.parametrize(("row", "column"), list(product(range(5), repeat=2)))
def test_every_cell_of_the_figure(row: int, column: int) -> None:
    # Requirements 36 to 42.
    assert ORDER[row] & ORDER[column] is FIGURE_4[row][column]


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


# Five elements: try them all instead of sampling them.
@pytest.mark.parametrize(("a", "b", "c"), list(product(Support, repeat=3)))
def test_order_and_grouping_never_matter(a: Support, b: Support, c: Support) -> None:
    # Requirements 43 to 46.
    assert a & b is b & a
    assert (a & b) & c is a & (b & c)
    assert combine(np.array([a, b, c])) == (a & b) & c


def test_a_walk_alone_overrides_the_neutral_motion() -> None:
    # Requirements 47 and 48.
    synchronizer = Synchronizer([SupportSequence.parse("R D L D*")], planner="paper")
    assert synchronizer.result is DS
    synchronizer.start(0)
    results = [synchronizer.result, *(synchronizer.next_slot() for _ in range(4))]
    assert results == [RS, DS, LS, DS, RS]
    synchronizer.stop(0)
    assert synchronizer.result is DS
