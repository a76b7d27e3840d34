"""Write docs/comparison.md and its pictures.

Run as ``python -m benchmarks.comparison``; exits with 1 where it took longer than its budget.
"""

from __future__ import annotations

import sys
import time

from benchmarks.comparison.contacts import on_labeled_clips, on_samples
from benchmarks.comparison.contacts_page import contacts_section
from benchmarks.comparison.page import (
    detail_section,
    introduction,
    overall_section,
    pictures_section,
    slip_section,
)
from benchmarks.comparison.sheets import ROOT, SheetResult, play_sheets

from footfall.io import write_atomically
from footfall.report import performance_trace
from footfall.view import foot_traces_svg

BUDGET = 600.0
"""Longest that all of it may take [s]."""

PICTURES = ("01_walk_and_run", "07_walk_and_side_step", "06_run_and_jump")
"""Sheets whose feet are drawn."""

DRAWN = ("cross-fade", "equal-cycles", "marker-leader", "paper", "footfall")
"""Methods that are drawn."""


def main() -> int:
    """Measure everything and write the page."""
    begin = time.perf_counter()
    results: list[SheetResult] = []
    pictures: list[tuple[str, str]] = []
    for result in play_sheets():
        print(f"{time.perf_counter() - begin:6.1f} s  {result.name}", flush=True)
        if result.name in PICTURES:
            pictures.append((result.told, _draw(result)))
        result.performances.clear()
        results.append(result)
    page = (
        introduction(results)
        + slip_section(results)
        + overall_section(results)
        + pictures_section(pictures)
        + contacts_section(list(on_samples()), list(on_labeled_clips()))
        + detail_section(results)
    )
    write_atomically(ROOT / "docs" / "comparison.md", page.encode())
    seconds = time.perf_counter() - begin
    print(f"comparison_s  {seconds:6.1f}   budget <= {BUDGET:.0f}")
    return int(seconds > BUDGET)


def _draw(result: SheetResult) -> str:
    """Draw the feet of a sheet by each method; return the file relative to the page."""
    name = f"images/comparison/{result.name[3:].replace('_', '-')}.svg"
    path = ROOT / "docs" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    traces = [(method, performance_trace(result.performances[method])) for method in DRAWN]
    write_atomically(path, foot_traces_svg(traces).encode())
    return name


if __name__ == "__main__":
    sys.exit(main())
