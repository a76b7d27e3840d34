from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.io.number_table import parse_table

numbers = st.one_of(
    st.floats(allow_nan=False, allow_infinity=False).map(repr),
    st.floats(-1e6, 1e6).map(lambda value: f"{value:.6f}"),
    st.from_regex(
        r"[+-]?([0-9]{1,25}\.?[0-9]{0,25}|\.[0-9]{1,25})([eE][+-]?[0-9]{1,3})?", fullmatch=True
    ),
)


@settings(deadline=None, max_examples=500)
@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=5), st.sampled_from(" \t\r\v"))
def test_every_number_is_what_python_reads(rows: list[tuple[str, str]], blank: str) -> None:
    text = "\n\n".join(f"{blank}{one}{blank} {other}" for one, other in rows) + "\n \n"
    table = parse_table(text.encode(), len(rows), 2)
    assert table is not None
    expected = np.array([[float(one), float(other)] for one, other in rows])
    assert table.tobytes() == expected.tobytes() or np.array_equal(table, expected)


@pytest.mark.parametrize(
    "word",
    [
        "nan",
        "inf",
        "-",
        "+",
        ".",
        "1e",
        "1e+",
        "e5",
        "1.2.3",
        "1,5",
        "0x10",
        "1_0",
        "--1",
        "1-2",
        "\u0661",
    ],
)
def test_a_word_that_is_no_number_makes_no_table(word: str) -> None:
    assert parse_table(f"1 {word}\n".encode(), 1, 2) is None


@pytest.mark.parametrize(
    "text", ["1 2\n3\n", "1 2 3\n4\n", "1 2\n", "1 2\n3 4\n5 6\n", "1\n2\n3\n4\n", ""]
)
def test_any_other_shape_makes_no_table(text: str) -> None:
    assert parse_table(text.encode(), 2, 2) is None


def test_a_line_need_not_end() -> None:
    table = parse_table(b"1 2\n3 4", 2, 2)
    assert table is not None
    assert table.tolist() == [[1.0, 2.0], [3.0, 4.0]]
