from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

from footfall.datasets.histogram import BINS, histogram_svg


def counts(svg: str) -> list[int]:
    return [int(count) for count in re.findall(r"mm: (\d+) files", svg)]


@pytest.mark.parametrize("values", [[0.0], [1.0, 2.0, 3.0], [5.0] * 7, list(range(1000))])
def test_every_value_is_counted_once(values: list[float]) -> None:
    svg = histogram_svg(values, "slip [mm]")
    ElementTree.fromstring(svg)
    assert sum(counts(svg)) == len(values)


def test_one_far_out_does_not_squeeze_the_others() -> None:
    svg = histogram_svg([*map(float, range(1, 100)), 1e6], "slip [mm]")
    assert len(counts(svg)) > BINS // 5
    assert " and more</text>" in svg


def test_without_values_it_is_a_sentence() -> None:
    assert histogram_svg([], "slip") == "<p>There is nothing to measure.</p>"
