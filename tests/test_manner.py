"""The measures of the house: how long a module and a function may be, and what none is called."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import footfall

ROOT = Path(footfall.__file__).parent
SOURCES = sorted(ROOT.rglob("*.py"))
MODULE_LINES = 250
FUNCTION_LINES = 40
"""Docstrings are not counted: nobody should write a shorter one for a longer function."""

FORBIDDEN_WORDS = {"utils", "util", "helpers", "helper", "common", "misc", "base", "manager"}
FORBIDDEN_PREFIXES = ("get_", "compute_")

every_source = pytest.mark.parametrize(
    "path", SOURCES, ids=lambda path: str(path.relative_to(ROOT))
)

Function = ast.FunctionDef | ast.AsyncFunctionDef


def functions(source: str) -> list[Function]:
    return [node for node in ast.walk(ast.parse(source)) if isinstance(node, Function)]


def lines(function: Function) -> int:
    """Return how many lines a function has, from its `def` to its end, without docstring."""
    last = function.end_lineno or function.lineno
    count = last - function.lineno + 1
    if ast.get_docstring(function) is not None:
        docstring = function.body[0]
        count -= (docstring.end_lineno or docstring.lineno) - docstring.lineno + 1
    return count


def long_functions(source: str) -> list[str]:
    return [
        f"{function.name} has {lines(function)} lines, {FUNCTION_LINES} at most"
        for function in functions(source)
        if lines(function) > FUNCTION_LINES
    ]


def misnamed_functions(source: str) -> list[str]:
    return [
        function.name
        for function in functions(source)
        if function.name.lstrip("_").startswith(FORBIDDEN_PREFIXES)
    ]


@every_source
def test_no_module_is_long(path: Path) -> None:
    count = len(path.read_text().splitlines())
    assert count <= MODULE_LINES


@every_source
def test_no_function_is_long(path: Path) -> None:
    assert long_functions(path.read_text()) == []


@every_source
def test_no_module_has_a_name_that_says_nothing(path: Path) -> None:
    words = {
        word for part in path.relative_to(ROOT).with_suffix("").parts for word in part.split("_")
    }
    assert words & FORBIDDEN_WORDS == set()


@every_source
def test_no_function_gets_or_computes(path: Path) -> None:
    assert misnamed_functions(path.read_text()) == []


@every_source
def test_nothing_is_left_to_do_and_no_code_is_kept_in_comments(path: Path) -> None:
    source = path.read_text()
    assert re.findall(r"\b(?:TODO|FIXME|XXX|HACK)\b", source) == []
    assert (
        re.findall(r"(?m)^\s*#\s*(?:def |class |import |from \w+ import |return\b.*[)\]])", source)
        == []
    )


def test_a_long_function_is_found_and_a_long_docstring_is_no_fault() -> None:
    body = "    x = 1\n"
    fits = "def f():\n" + body * (FUNCTION_LINES - 1)
    text = '    """One.\n' + "\n    More.\n" * 30 + '    """\n'
    assert long_functions(fits) == []
    assert long_functions(fits.replace("def f():\n", "def f():\n" + text)) == []
    assert long_functions(fits + body) == ["f has 41 lines, 40 at most"]
    assert long_functions("class A:\n    async " + (fits + body).replace("\n", "\n    ")) != []


def test_a_function_that_gets_is_found() -> None:
    assert misnamed_functions("def get_pose(): ...\ndef _compute_it(): ...\ndef target(): ...") == [
        "get_pose",
        "_compute_it",
    ]


def test_there_are_sources_to_look_at() -> None:
    assert len(SOURCES) > 30
