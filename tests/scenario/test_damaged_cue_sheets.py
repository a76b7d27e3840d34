"""Whatever a cue sheet says, it is read, or refused in one line: never a traceback."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.errors import FootfallError
from footfall.scenario.cue_sheet import load_scenario, parse_scenario
from footfall.scenario.performance import load_motions

SHEET = """\
fps = 60
duration = 6.5
body = "sample:walk"

[[action]]
name = "walk"
motion = "sample:walk"
cyclic = true

[[action]]
name = "kick"
motion = "sample:kick"
priority = { legs = 1.0, arms = 0.2 }
fade_in = 0.2
crop = [0.1, 1.9]

[[cue]]
at = 0.0
start = "walk"

[[cue]]
at = 2.13
priority = { kick = 2.0 }

[[cue]]
at = 3.0
ground = 0.2
"""

VALUES: st.SearchStrategy[Any] = st.sampled_from(
    [
        "-1", "0", "1e400", "nan", "inf", "-inf", "true", '""', '"walk"', '"sample:"', '"/"', "[]",
        "[1, 2]", "[2.0, 1.0]", "[nan, 1]", "{}", "{ legs = -1 }", "{ tail = 1 }", "1979-05-27",
        "99999999999999999999", '"sample:walk#1"', '"\\u0000"', "[[1]]", "1_0.5e-3",
    ]
)  # fmt: skip


def answer(read: Callable[[], object], name: str) -> None:
    """Read something; a refusal is one line that names the file."""
    told = f"{name}: read"
    try:
        read()
    except FootfallError as error:
        told = str(error)
    assert told.startswith(name)
    assert "\n" not in told


def answer_text(text: str) -> None:
    answer(lambda: load_motions(parse_scenario(text, "cues.toml")), "cues.toml")


@settings(max_examples=150, deadline=None)
@given(line=st.integers(0, SHEET.count("\n") - 1), value=VALUES)
def test_any_value_of_any_field(line: int, value: str) -> None:
    lines: list[str] = [*SHEET.splitlines()]
    key = lines[line].split("=")[0]
    lines[line] = f"{key} = {value}" if "=" in lines[line] else value
    answer_text("\n".join(lines))


@settings(max_examples=150, deadline=None)
@given(data=st.data())
def test_any_cut_doubled_or_damaged_piece(data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(SHEET)))
    end = data.draw(st.integers(start, min(start + 60, len(SHEET))))
    piece = data.draw(st.sampled_from(["", SHEET[start:end] * 2, "\x00", "]", '"', "é", "= =\n"]))
    answer_text(SHEET[:start] + piece + SHEET[end:])


@settings(max_examples=60, deadline=None)
@given(data=st.binary(max_size=300))
def test_any_bytes(data: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "any.toml"
    Path(path).write_bytes(data)
    answer(lambda: load_scenario(path), str(path))
