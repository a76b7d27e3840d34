from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from tests.paper.requirements import requirement

from footfall.support import Support, combine
from footfall.support.algebra import EVERY_LIMB

D, R, L, ERR, NO = (
    Support.DOUBLE,
    Support.RIGHT,
    Support.LEFT,
    Support.CONFLICT,
    Support.FLIGHT,
)
ORDER = (D, R, L, ERR, NO)
# Figure 4, in the paper's order.
TABLE = (
    (D, R, L, ERR, NO),
    (R, R, ERR, ERR, NO),
    (L, ERR, L, ERR, NO),
    (ERR, ERR, ERR, ERR, NO),
    (NO, NO, NO, NO, NO),
)


@pytest.mark.parametrize(("row", "column"), list(product(range(5), repeat=2)))
def test_every_cell_of_the_relation(row: int, column: int) -> None:
    assert (ORDER[row] & ORDER[column]) is TABLE[row][column]


@pytest.mark.parametrize(("a", "b", "c"), list(product(Support, repeat=3)))
def test_order_and_grouping_never_matter(a: Support, b: Support, c: Support) -> None:
    assert (a & b) is (b & a)
    assert ((a & b) & c) is (a & (b & c))


@pytest.mark.parametrize("a", list(Support))
def test_repetition_changes_nothing_double_gives_way_and_flight_absorbs(a: Support) -> None:
    assert (a & a) is a
    assert (a & D) is a
    assert (a & NO) is NO


@pytest.mark.parametrize(("a", "b", "c"), list(product(Support, repeat=3)))
def test_many_at_once_are_combined_as_one_after_the_other(
    a: Support, b: Support, c: Support
) -> None:
    assert combine(np.array([a, b, c])) == a & b & c


def test_columns_are_combined_over_the_axis_asked_for() -> None:
    rows = np.array([[R, D, L, NO], [R, L, R, ERR]])
    assert combine(rows).tolist() == [R, L, ERR, NO]
    assert combine(rows.T, axis=1).tolist() == [R, L, ERR, NO]


def test_the_combination_of_no_supports_is_neutral() -> None:
    everything = combine(np.zeros((0, 3), dtype=np.int64))
    assert (everything & D).tolist() == [D, D, D]


@pytest.mark.parametrize(
    ("support", "symbol"), [(D, "D"), (R, "R"), (L, "L"), (NO, "-"), (ERR, "Err")]
)
def test_every_support_has_its_letter(support: Support, symbol: str) -> None:
    assert support.symbol == symbol
    if support is not ERR:
        assert Support.from_symbol(symbol) is support


@pytest.mark.parametrize("symbol", ["Err", "", "r", "DS", " "])
def test_no_other_letter_means_a_support(symbol: str) -> None:
    with pytest.raises(KeyError):
        Support.from_symbol(symbol)


@pytest.mark.parametrize(("left", "right"), list(product([False, True], repeat=2)))
def test_feet_and_supports_are_the_same_thing(left: bool, right: bool) -> None:
    support = Support.from_feet(left, right)
    assert (support.left, support.right) == (left, right)


def test_in_a_conflict_no_foot_carries() -> None:
    assert (ERR.left, ERR.right) == (False, False)


@pytest.mark.parametrize("limb", range(6))
def test_every_limb_has_a_bit_of_its_own_beside_that_of_the_ground(limb: int) -> None:
    assert int(Support.from_limbs([limb])) == 1 | 2 << limb


@requirement(43, "As our relation is commutative, two motions")
@requirement(44, "as our algebraic relation is associative")
def test_with_hands_and_more_legs_order_and_grouping_never_matter_either() -> None:
    # The 65 sets that six limbs give: no limb and in the air, no limb in common, and 63 others.
    every = [NO, *(Support(bits) for bits in range(1, EVERY_LIMB + 1, 2))]
    assert len(every) == 65
    for a, b in product(every, repeat=2):
        together = a & b
        assert together is (b & a)
        assert together in every
        if NO not in (a, b):
            assert together.limbs == tuple(limb for limb in a.limbs if limb in b.limbs)
    hands = [one for one in every if all(limb < 4 for limb in one.limbs)]
    assert len(hands) == 17
    for a, b, c in product(hands, repeat=3):
        assert ((a & b) & c) is (a & (b & c))


def test_every_limb_at_once_is_every_bit() -> None:
    assert EVERY_LIMB == 0b1111111
