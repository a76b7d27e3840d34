from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from footfall.arrays import SmallFloats
from footfall.compilation import kernel
from footfall.octet_memory import load, spread, store, transpose
from footfall.octets import exponential, greater, select, smaller, square_root

eights = arrays(np.float32, 8, elements=st.floats(-100.0, 100.0, width=32))


@kernel
def formula(x: float, y: float) -> tuple[float, float]:
    """Use every operation, on two numbers or on two octets."""
    mean = 0.5 * (x + y) - x / (2.0 + y * y)
    root = square_root(greater(mean, 0.0)) + exponential(smaller(-mean, 3.0))
    return select(x < y, root, -mean), select(x >= 0.25, 1.0, y)


@kernel
def formula_of_numbers(x: float, y: float) -> tuple[float, float]:
    return formula(x, y)


@kernel
def formula_of_eight(x: SmallFloats, y: SmallFloats, out: SmallFloats) -> None:
    one, other = formula(load(x, 0), load(y, 0))
    store(out, 0, one)
    store(out, 8, other)


# The square root of a difference keeps but half of its digits.
@settings(deadline=None, max_examples=50)
@given(eights, eights)
def test_eight_at_once_are_eight_times_one(x: SmallFloats, y: SmallFloats) -> None:
    out = np.zeros(16, dtype=np.float32)
    formula_of_eight(x, y, out)
    singly = np.array([formula_of_numbers(float(a), float(b)) for a, b in zip(x, y, strict=True)])
    assert out[:8] == pytest.approx(singly[:, 0], rel=1e-4, abs=5e-3)
    assert out[8:] == pytest.approx(singly[:, 1], rel=1e-6)


@kernel
def exchange(array: SmallFloats, out: SmallFloats) -> None:
    transpose(array, 3, 11, out, 8)


def test_rows_become_columns_wherever_they_lie() -> None:
    array = np.arange(100, dtype=np.float32)
    out = np.zeros(80, dtype=np.float32)
    exchange(array, out)
    rows = np.stack([array[3 + 11 * k : 11 + 11 * k] for k in range(8)])
    assert np.array_equal(out[8:72].reshape(8, 8), rows.T)
    assert not out[:8].any()
    assert not out[72:].any()


@kernel
def fill(out: SmallFloats, number: float) -> None:
    store(out, 1, spread(number))


def test_one_number_is_eight_equal_ones_and_no_more() -> None:
    out = np.zeros(10, dtype=np.float32)
    fill(out, 1.5)
    assert out.tolist() == [0.0] + [1.5] * 8 + [0.0]
