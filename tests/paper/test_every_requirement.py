"""No requirement is forgotten: the list, the tests that are marked, and docs/paper.md agree."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.paper.requirements import REQUIREMENTS, requirement

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")
ORIGINAL = sorted((ROOT.parent / "shared" / "paper").glob("*.txt"))

PLACES = (
    "abstract",
    "1",
    "2",
    "3",
    "4.1",
    "4.2",
    "4.3",
    "5",
    "5.1",
    "5.2",
    "5.3",
    "6",
    "7",
    "appendix A",
    *(f"figure {number}" for number in range(1, 19)),
    *(f"equation {number}" for number in range(1, 13)),
)

LIMITATION = "limitation"


class Row(NamedTuple):
    """One row of a table of the page."""

    key: str
    words: str
    functions: tuple[str, ...]
    tests: tuple[str, ...]
    limited: bool


def rows_below(heading: str, key: str) -> list[Row]:
    """Return the rows of the tables below a heading, up to the next one of its rank."""
    part = PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    rows: list[Row] = []
    for name, words, code, tests in re.findall(
        rf"(?m)^\| ({key}) \| (.*?) \| (.*?) \| (.*?) \|$", part
    ):
        cells = [tuple(re.findall(r"`([^`]+)`", cell)) for cell in (code, tests)]
        rows.append(Row(name, words, cells[0], cells[1], LIMITATION in tests))
    return rows


BY_PLACE = rows_below("Sections, figures and equations", "(?!paper )[a-z1-7][^|]*?")
BY_NUMBER = rows_below("The requirements", r"\d+")


def marks_of(source: str) -> dict[int, list[str]]:
    """Return the functions that are marked with each number in a source."""
    found: dict[int, list[str]] = {}
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.FunctionDef):
            continue
        for mark in node.decorator_list:
            if not isinstance(mark, ast.Call) or not isinstance(mark.func, ast.Name):
                continue
            if mark.func.id == "requirement":
                number = ast.literal_eval(mark.args[0])
                found.setdefault(number, []).append(node.name)
    return found


def marked_tests() -> dict[int, set[str]]:
    """Return the tests that are marked with each number, as the page names them."""
    found: dict[int, set[str]] = {}
    for path in sorted((ROOT / "tests").rglob("test_*.py")):
        source = path.read_text(encoding="utf-8")
        if "requirement(" in source:
            for number, names in marks_of(source).items():
                tests = {f"{path.relative_to(ROOT / 'tests')}::{name}" for name in names}
                found.setdefault(number, set()).update(tests)
    return found


MARKED = marked_tests()


def exists(test: str) -> bool:
    """Whether there is a test file, or a test in it, of this name below tests/."""
    file, _, name = test.partition("::")
    path = ROOT / "tests" / file
    return path.is_file() and (not name or f"\ndef {name}(" in path.read_text(encoding="utf-8"))


def imported(dotted: str) -> object:
    """Return what a dotted name stands for.

    Raises:
        ImportError: If there is no such module.
        AttributeError: If the module has no such name.
    """
    parts = dotted.split(".")
    for cut in range(len(parts), 0, -1):
        try:
            thing: object = importlib.import_module(".".join(parts[:cut]))
        except ModuleNotFoundError:
            continue
        for name in parts[cut:]:
            thing = getattr(thing, name)
        return thing
    raise ImportError(f"no module in {dotted}")


def test_the_list_is_whole() -> None:
    assert list(REQUIREMENTS) == list(range(1, 134))
    assert all(one.place in (*PLACES, "implied") for one in REQUIREMENTS.values())
    assert all("|" not in one.sentence for one in REQUIREMENTS.values())


@pytest.mark.skipif(not ORIGINAL, reason="the paper's text lies outside the project")
def test_the_paper_says_it_in_these_words() -> None:
    text = " ".join(ORIGINAL[0].read_text(encoding="utf-8").split()).replace("*", "")
    for one in REQUIREMENTS.values():
        assert one.place == "implied" or one.sentence in text, one.number


@pytest.mark.parametrize("number", REQUIREMENTS)
def test_each_is_shown_by_a_test_or_told_as_a_limitation(number: int) -> None:
    row = BY_NUMBER[number - 1]
    assert row.key == str(number)
    assert row.words == f'"{REQUIREMENTS[number].sentence}"'
    assert set(row.tests) == MARKED.get(number, set())
    assert row.tests or row.limited
    assert all(exists(test) for test in row.tests)
    for function in row.functions:
        assert imported(function) is not None
    assert row.functions or row.limited


def test_each_limitation_is_told_in_a_paragraph_of_its_own() -> None:
    told = PAGE.split("\n## Limitations\n")[1].split("\n## ")[0]
    numbers = {int(number) for number in re.findall(r"(?m)^- \*\*(\d+)\*\*", told)}
    assert numbers == {int(row.key) for row in BY_NUMBER if row.limited}


def test_every_section_figure_and_equation_has_its_code_and_its_test() -> None:
    named = [place for row in BY_PLACE for place in row.key.split(", ")]
    assert sorted(named) == sorted(PLACES)
    for row in BY_PLACE:
        assert row.functions, row.key
        assert row.tests, row.key
        assert all(exists(test) for test in row.tests), row.key
        for function in row.functions:
            assert imported(function) is not None


def test_there_is_no_other_row() -> None:
    assert len(BY_NUMBER) == len(REQUIREMENTS)


@pytest.mark.parametrize(
    ("number", "sentence", "message"),
    [
        (0, "", "no requirement 0; there are 1 to 133"),
        (40, "Ø is absorbing.", "requirement 40 reads 'Ø is the absorbing element.'"),
    ],
)
def test_a_mark_with_other_words_is_refused(number: int, sentence: str, message: str) -> None:
    with pytest.raises(ValueError) as caught:  # noqa: PT011
        requirement(number, sentence)
    assert str(caught.value) == message


def test_marks_are_found_and_missing_names_are_noticed() -> None:
    source = "@other(1)\n@requirement(7, 'x')\n@requirement(8, 'y')\ndef test_it(): ...\n"
    assert marks_of(source) == {7: ["test_it"], 8: ["test_it"]}
    assert not exists("paper/test_every_requirement.py::test_nothing")
    assert not exists("paper/test_nothing.py")
    with pytest.raises(AttributeError):
        imported("footfall.sync.planner.nothing")
