from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from footfall import benchmark
from footfall.benchmark import Row, rows_json, table_text
from footfall.benchmark.picture import cost_picture
from footfall.cli import main

ROWS = [Row("fast_us", 0.5, 0.6, "us"), Row("slow_us", 7.0, 1.0, "us"), Row("ratio", 4.0, None, "")]


def test_a_budget_that_is_not_met_is_marked() -> None:
    lines = table_text(ROWS).splitlines()
    assert [("*" in line) for line in lines] == [False, False, True, False]


def test_the_command_ends_with_the_table_as_json(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def measured(tell: Callable[[str], None]) -> list[Row]:
        tell("measuring ...")
        return ROWS

    monkeypatch.setattr(benchmark, "measure_all", measured)
    assert main(["bench", "--json"]) == 0
    shown = capsys.readouterr()
    assert json.loads(shown.out.splitlines()[-1]) == json.loads(rows_json(ROWS))
    assert json.loads(rows_json(ROWS))["rows"][1] == {
        "name": "slow_us",
        "value": 7.0,
        "budget": 1.0,
        "unit": "us",
    }
    assert shown.err == "measuring ...\n"


def test_the_picture_shows_every_cost() -> None:
    svg = cost_picture({1: 9.0, 1000: 0.75, 10_000: 1.25}, {1: 0.5, 8: 2.5})
    assert svg.count("<circle") == 5
    for words in ("9.00", "0.75", "1.25", "0.50", "2.50", "actions, N = 1 000"):
        assert words in svg
