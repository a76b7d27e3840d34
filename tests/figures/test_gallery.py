"""The gallery that is committed, and what every figure must be.

After a wanted change: ``footfall figures -o docs/gallery --no-animations``; look at the pictures.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from tests.figures.drawn import SVG, cast, drawn, picture
from tests.figures.marks import NUMBER, count, others

from footfall.figures import DRAWINGS, Cast, write_gallery
from footfall.figures.animations import ANIMATIONS
from footfall.figures.gallery import COMMAND, gallery_text
from footfall.view.text_width import text_width

GALLERY = Path(__file__).parents[2] / "docs" / "gallery"
SEARCHED = (15, 16, 18)
"""Figures whose character acts on what it is doing: where two ways of going on are as good as each
other, what a processor rounds decides, and a foot stands some pixels elsewhere from then on."""

every_figure = pytest.mark.parametrize("number", DRAWINGS)


def test_there_is_a_figure_for_every_number_but_the_first() -> None:
    assert list(DRAWINGS) == list(range(2, 19))
    assert [drawn(number).number for number in DRAWINGS] == list(DRAWINGS)


@every_figure
def test_a_committed_picture_is_what_is_drawn(number: int) -> None:
    figure = drawn(number)
    committed = (GALLERY / f"{figure.stem}.svg").read_text(encoding="utf-8")
    assert others(committed, figure.svg, 15.0 if number in SEARCHED else 1.0) <= (
        0.05 * count(figure.svg) if number in SEARCHED else 0
    )


def test_a_picture_that_is_another_one_is_noticed() -> None:
    assert others(drawn(2).svg, drawn(3).svg, 1.0) > 0
    assert others(drawn(15).svg, drawn(16).svg, 15.0) > 0.5 * count(drawn(15).svg)


def test_a_mark_that_moved_or_is_missing_or_looks_otherwise_is_noticed() -> None:
    svg = '<svg><g stroke="red"/><polygon points="1,2 5,2 1,9"/><text x="12.5">a 3</text></svg>'
    assert count(svg) == 4
    assert others(svg, svg.replace("12.5", "12.6").replace("1,2 5,2", "5,2 1,2 1,2"), 1.0) == 0
    for was, now in (("12.5", "13.6"), ("5,2", "7,2"), ("a 3", "a 5"), ("a 3", "b 3"), ("red", "")):
        assert others(svg, svg.replace(was, now), 1.0) >= 1
    assert others(svg, svg.replace('<g stroke="red"/>', ""), 1.0) == 1


def assert_same_facts(one: str, other: str) -> None:
    """Compare pages word by word; what was measured may differ by what two processors do."""
    assert NUMBER.sub("#", one) == NUMBER.sub("#", other)
    for line, like in zip(one.splitlines(), other.splitlines(), strict=True):
        for a, b in zip(NUMBER.findall(line), NUMBER.findall(like), strict=True):
            measured = line.startswith("- ")
            assert abs(float(a) - float(b)) <= (max(0.2, 0.1 * abs(float(a))) if measured else 0.0)


def test_the_committed_page_is_what_is_written() -> None:
    figures = tuple(drawn(number) for number in DRAWINGS)
    text = gallery_text(figures, cast(), animations=False)
    assert_same_facts((GALLERY / "README.md").read_text(encoding="utf-8"), text)


def test_another_fact_is_noticed() -> None:
    assert_same_facts("## 3\n- at 3.0 s, 9.2 cm", "## 3\n- at 3.1 s, 8.8 cm")
    for other in ("## 4\n- at 3.0 s, 9.2 cm", "## 3\n- at 3.4 s, 9.2 cm", "## 3\n- at 3.0 s, 8 m"):
        with pytest.raises(AssertionError):
            assert_same_facts("## 3\n- at 3.0 s, 9.2 cm", other)


def test_nothing_else_is_committed_and_the_page_names_its_command() -> None:
    names = {f"{drawn(number).stem}.svg" for number in DRAWINGS} | {"README.md"}
    assert {path.name for path in GALLERY.iterdir()} == names
    assert f"Drawn by `{COMMAND}`." in (GALLERY / "README.md").read_text(encoding="utf-8")


@every_figure
def test_a_figure_has_a_heading_a_claim_and_what_was_measured(number: int) -> None:
    figure = drawn(number)
    assert figure.stem.startswith(f"figure_{number:02d}_")
    texts = [text.text for text in picture(number).iter(f"{SVG}text")]
    assert texts[:2] == [f"Figure {number}", figure.title]
    assert len(figure.claim) > 20
    assert figure.facts
    assert all(fact.endswith(".") for fact in figure.facts)


@every_figure
def test_no_words_are_cut_at_the_edges(number: int) -> None:
    root = picture(number)
    _, _, width, height = (float(part) for part in root.attrib["viewBox"].split())
    for text in root.iter(f"{SVG}text"):
        size, bold = float(text.attrib["font-size"]), "font-weight" in text.attrib
        wide = 0.9 * text_width(text.text or "", size, bold=bold)
        share = {"middle": 0.5, "end": 1.0}.get(text.attrib.get("text-anchor", ""), 0.0)
        left = float(text.attrib["x"]) - share * wide
        assert left >= 0.0, text.text
        assert left + wide <= width, text.text
        assert size <= float(text.attrib["y"]) <= height - 3.0, text.text


@every_figure
def test_a_figure_stands_on_paper_of_its_own_in_light_and_dark(number: int) -> None:
    svg = drawn(number).svg
    assert '<rect width="100%" height="100%" class="paper"/>' in svg
    assert "@media(prefers-color-scheme:dark)" in svg


@every_figure
def test_a_figure_needs_no_network(number: int) -> None:
    assert set(re.findall(r"https?://[^\s\"'<>)]+", drawn(number).svg)) == {
        "http://www.w3.org/2000/svg"
    }


def test_everything_is_written_and_written_again_with_the_same_bits(tmp_path: Path) -> None:
    written: list[dict[str, bytes]] = []
    for place in ("one", "other"):
        folder = tmp_path / place
        folder.mkdir()
        write_gallery(folder, Cast.of_samples())
        written.append({path.name: path.read_bytes() for path in folder.iterdir()})
    stems = {drawn(number).stem for number in DRAWINGS}
    assert set(written[0]) == {f"{stem}.svg" for stem in stems} | set(ANIMATIONS) | {"README.md"}
    assert written[0] == written[1]
    for name in ANIMATIONS:
        assert f"[{name}]({name})" in written[0]["README.md"].decode()


def test_a_picture_that_is_not_well_formed_is_noticed() -> None:
    with pytest.raises(ElementTree.ParseError):
        ElementTree.fromstring(drawn(4).svg.replace("</svg>", ""))
