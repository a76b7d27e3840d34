"""The gallery that is committed, and what every figure must be.

After a wanted change: ``footfall figures -o docs/gallery --no-animations``; look at the pictures.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from tests.figures.drawn import SVG, cast, drawn, picture

from footfall.figures import DRAWINGS, Cast, write_gallery
from footfall.figures.animations import ANIMATIONS
from footfall.figures.gallery import COMMAND, gallery_text
from footfall.view.text_width import text_width

GALLERY = Path(__file__).parents[2] / "docs" / "gallery"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
every_figure = pytest.mark.parametrize("number", DRAWINGS)


def test_there_is_a_figure_for_every_number_but_the_first() -> None:
    assert list(DRAWINGS) == list(range(2, 19))
    assert [drawn(number).number for number in DRAWINGS] == list(DRAWINGS)


def assert_same_but_for_rounding(one: str, other: str, tolerance: float) -> None:
    """Compare texts word by word; numbers may differ by what another processor rounds."""
    assert NUMBER.sub("#", one) == NUMBER.sub("#", other)
    pairs = zip(NUMBER.findall(one), NUMBER.findall(other), strict=True)
    assert max((abs(float(a) - float(b)) for a, b in pairs), default=0.0) <= tolerance


@every_figure
def test_a_committed_picture_is_what_is_drawn(number: int) -> None:
    figure = drawn(number)
    committed = (GALLERY / f"{figure.stem}.svg").read_text(encoding="utf-8")
    assert_same_but_for_rounding(committed, figure.svg, 1.0)


def test_a_picture_that_is_another_one_is_noticed() -> None:
    with pytest.raises(AssertionError):
        assert_same_but_for_rounding(drawn(2).svg, drawn(3).svg, 1.0)
    with pytest.raises(AssertionError):
        assert_same_but_for_rounding('x="12.5"', 'x="13.6"', 1.0)
    assert_same_but_for_rounding('x="12.5"', 'x="12.6"', 1.0)


def test_the_committed_page_is_what_is_written() -> None:
    figures = tuple(drawn(number) for number in DRAWINGS)
    text = gallery_text(figures, cast(), animations=False)
    committed = (GALLERY / "README.md").read_text(encoding="utf-8")
    assert_same_but_for_rounding(committed, text, 0.2)


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
