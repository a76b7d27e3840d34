"""Figures 4 and 6 to 9: what stands in their cells."""

from __future__ import annotations

from tests.figures.drawn import attributes, drawn, words

from footfall.support import Support
from footfall.view.palette import SLIP, SUPPORT_COLORS

NOTATION = ("DS", "RS", "LS", "Err", "Ø")


def cells(number: int) -> list[str]:
    """Return the supports that are written in a figure, in the order of drawing."""
    return [word for word in words(number) if word in NOTATION]


def test_figure_4_has_the_table_of_the_paper() -> None:
    # After the headings of both sides, row by row.
    table = cells(4)[10:35]
    assert [" ".join(table[row : row + 5]) for row in range(0, 25, 5)] == [
        "DS RS LS Err Ø",
        "RS RS Err Err Ø",
        "LS Err LS Err Ø",
        "Err Err Err Err Ø",
        "Ø Ø Ø Ø Ø",
    ]
    # Nine cells and the conflict in the order of supports.
    assert len(attributes(4, "rect", fill=SLIP)) == 9
    assert len(attributes(4, "circle", fill=SLIP)) == 1


def test_figure_4_draws_the_order_that_the_supports_have() -> None:
    # DS over LS and RS over Err over Ø: five steps.
    diagonal = [line for line in attributes(4, "line") if float(line["x1"]) > 700.0]
    assert len(diagonal) == 5


def test_figure_6_has_the_rows_of_the_paper_and_the_appended_part_is_pale() -> None:
    texts = cells(6)
    assert " ".join(texts[:8]) == "RS DS LS DS RS DS LS DS"
    assert " ".join(texts[8:]) == "LS DS Ø DS LS LS LS LS"
    assert len(attributes(6, "rect", fill="none")) == 4 + 3
    assert words(6).count("chronological order") == 1


def test_figure_7_counts_each_action_from_its_start_and_all_of_them_by_k() -> None:
    texts = words(7)
    for name, count in (("S₁", 8), ("S₂", 7), ("S₃", 5)):
        assert [f"{name}({k})" in texts for k in range(1, count + 2)] == [True] * count + [False]
    for index in ("k−1", "k", "k+1", "k+2", "k+3"):
        assert [texts.count(f"S′{row}({index})") for row in "₁₂₃"] == [1, 1, 1]
    assert [fact.split(":")[0] for fact in drawn(7).facts] == ["walk", "fast walk", "jump"]


def test_figure_8_has_one_conflict_before_and_none_after_and_one_extended_element() -> None:
    texts = cells(8)
    # The sequences as they are, and what they make together.
    assert " ".join(texts[:12]) == "DS RS DS LS Ø LS DS Ø Ø Err DS Ø"
    # The same with S1(k+1) extended.
    assert " ".join(texts[12:]) == "DS DS RS DS Ø LS DS Ø Ø LS RS Ø"
    assert len(attributes(8, "rect", fill="url(#figure-08-held)")) == 1


def test_figure_9_respects_whoever_has_priority() -> None:
    texts = cells(9)
    rows = [texts[start : start + 7] for start in range(0, len(texts), 7)]
    assert len(rows) == 9
    assert rows[2].count("Err") == 3
    # Whoever leads is never extended.
    assert (rows[3], rows[7]) == (rows[0], rows[1])
    for leader, result in ((rows[3], rows[5]), (rows[7], rows[8])):
        assert "Err" not in result
        for own, blend in zip(leader, result, strict=True):
            assert blend == own or own == "DS"
    assert len(attributes(9, "rect", fill="url(#figure-09-held)")) == 2


def test_a_support_has_the_color_of_all_pictures() -> None:
    greens = attributes(4, "rect", fill=SUPPORT_COLORS[Support.DOUBLE.symbol])
    assert len(greens) == 1
