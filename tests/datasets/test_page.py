from __future__ import annotations

import re

from footfall.datasets import ClipAnnotation
from footfall.datasets.page import MOST_ROWS, summary_page, worst_first


def row(file: str, slip: float | None) -> ClipAnnotation:
    return ClipAnnotation(
        file, 1, 1, seconds=2.0, supports="R1 D.5 L.5", spans=3, slip_p95_mm=slip, slip_max_mm=slip
    )


BAD = ClipAnnotation("<bad>.bvh", 1, 1, error="line 3: 'a' & 'b'")


def test_the_worst_come_first_and_those_without_slip_last() -> None:
    rows = [row("a", 1.0), row("b", None), row("c", 9.0), BAD, row("d", 5.0)]
    assert [one.file for one in worst_first(rows)] == ["c", "d", "a", "b"]


def test_the_page_shows_them_in_that_order_and_tells_what_failed() -> None:
    page = summary_page([row("small.bvh", 1.0), BAD, row("large.bvh", 1234.5)], "a & b")
    assert "<title>Supports of a &amp; b</title>" in page
    assert page.index("large.bvh") < page.index("small.bvh")
    assert "<td>&lt;bad&gt;.bvh</td><td>line 3: &#x27;a&#x27; &amp; &#x27;b&#x27;</td>" in page
    assert "1,234" in page
    assert "$" not in page.replace("${", "")


def test_supports_are_drawn_as_long_as_they_last() -> None:
    page = summary_page([row("a.bvh", 1.0)], "a")
    grown = re.findall(r"flex-grow:([\d.]+)", page)
    assert grown == ["1.000", "0.500", "0.500"]


def test_an_archive_of_ten_thousand_shows_the_worst_and_says_so() -> None:
    page = summary_page([row(f"{index}.bvh", float(index)) for index in range(10_000)], "a")
    assert page.count('class="strip"') == MOST_ROWS
    assert "The worst 500 of 10,000 are shown; the table holds all." in page
    assert len(page) < 500_000


def test_a_page_of_nothing_usable_is_a_page() -> None:
    page = summary_page([BAD], "a")
    assert "There is nothing to measure." in page
    assert "Not usable: 1" in page
