from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import pytest

from footfall.view.svg import Picture, number


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-0.0, "0"), (-0.001, "0"), (1.0, "1"), (100.0, "100"), (1.234, "1.23")],
)
def test_a_coordinate_is_short(value: float, text: str) -> None:
    assert number(value) == text


def test_a_picture_is_well_formed_whatever_its_words() -> None:
    picture = Picture("odd", 'a < b & "c"', 10, 20)
    picture.words(1, 2, "<walk> & 'run'", size=9)
    picture.line(0, 0, 1, 1, stroke_width=2, opacity=None)
    root = ElementTree.fromstring(picture.to_svg(note='"'))
    space = "{http://www.w3.org/2000/svg}"
    assert root.attrib["viewBox"] == "0 0 10 20"
    assert root.attrib["data-note"] == '"'
    assert root.findtext(f"{space}title") == 'a < b & "c"'
    text = root.find(f"{space}text")
    assert text is not None
    assert text.text == "<walk> & 'run'"
    line = root.find(f"{space}line")
    assert line is not None
    assert line.attrib == {"x1": "0", "y1": "0", "x2": "1", "y2": "1", "stroke-width": "2"}


def test_words_are_ink_unless_they_have_a_color() -> None:
    picture = Picture("ink", "ink", 10, 10)
    picture.words(0, 0, "a")
    picture.words(0, 0, "b", fill="#ffffff")
    picture.words(0, 0, "c", class_="soft")
    text = picture.to_svg()
    assert '<text class="ink" x="0" y="0" font-size="12">a</text>' in text
    assert '<text x="0" y="0" font-size="12" fill="#ffffff">b</text>' in text
    assert '<text class="soft" x="0" y="0" font-size="12">c</text>' in text
