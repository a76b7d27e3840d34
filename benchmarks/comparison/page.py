"""The page: tables and sentences made of figures."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from benchmarks.comparison.sheets import MethodResult, SheetResult

from footfall.arrays import Floats
from footfall.report import Spread
from footfall.scenario.methods import METHODS

OURS = "footfall"

SAME = 0.05
"""Slips closer than this are the same [mm]."""

REASONS = {
    "05_run_and_jump": (
        "its stances last a quarter of a second, of which 100 ms are left without the edges, and a "
        "footprint still takes hold of the foot meanwhile"
    )
}
"""Why ours is not the least, where that has been looked into."""

UNKNOWN = "why has not been looked into"

INTRODUCTION = """\
# Beside what others offer

Made by `make comparison`; no figure on this page is written by hand. {sheets} cue sheets, each
played at 60 frames a second by six methods from the same clips, the same cues at the same odd
moments, the same fades. The sheets over samples run everywhere
(`benchmarks/comparison/cue_sheets`); the clips of the others are captured motion, cleaned at
import, which the project does not contain (`tests/real/scenarios`).

## The methods
"""

FAIRNESS = """
The first three are `footfall.baselines`. They play what the engine plays, with the same poses,
fades and weighted root motion; only the time of the clips is theirs. Each is used as its users are
told to: cycles are counted from the landing of the same foot, clips of several strides count as
several cycles, one-shot motions stay outside the group. None of the first five holds planted feet:
compare them with `no-footprints`, and what that lacks with `footfall`.

A foot is judged while it should carry: by the schedule, where there is one; by the heaviest motion,
where there is none. Slip is the way of the carrying point over the ground during a support span
without 67 ms at each end.
"""


def markdown_table(headings: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table, its first column to the left and the others to the right."""
    lines = [f"| {' | '.join(headings)} |", "|" + " --- |" + " ---: |" * (len(headings) - 1)]
    lines += [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join(lines) + "\n"


def introduction(results: Sequence[SheetResult]) -> str:
    """Return the head of the page."""
    rows = [(f"`{name}`", method.imitates) for name, method in METHODS.items()]
    table = "\n".join(["| method | what it imitates |", "| --- | --- |"])
    table += "".join(f"\n| {name} | {told} |" for name, told in rows)
    count = f"{len(results)}"
    missing = ""
    if not any(result.captured for result in results):
        missing = "\nThe captured clips are not on this machine: their sheets are left out.\n"
    return INTRODUCTION.format(sheets=count) + "\n" + table + "\n" + FAIRNESS + missing


def slip_section(results: Sequence[SheetResult]) -> str:
    """Return the table of slips, and where ours is not the least."""
    rows: list[list[str]] = []
    worse: list[str] = []
    for result in results:
        slips = {name: one.blended_slips for name, one in result.methods.items()}
        least = min(p95(values) for values in slips.values())
        cells: list[str] = []
        for values in slips.values():
            cell = f"{np.median(values):.1f} / {p95(values):.1f}"
            cells.append(f"**{cell}**" if p95(values) <= least + SAME else cell)
        rows.append([_title(result), *cells])
        if p95(slips[OURS]) > least + SAME:
            worse.append(_where_not(result, slips))
    every = {
        name: np.concatenate([result.methods[name].blended_slips for result in results])
        for name in METHODS
    }
    rows.append(["**all**", *(f"{np.median(v):.1f} / {p95(v):.1f}" for v in every.values())])
    told = (
        "\n## Slip where motions blend\n\n"
        "Support spans in which weights move or several motions have some: median / 95th "
        "percentile in mm; the least 95th percentile is bold.\n\n"
    )
    table = markdown_table(["cue sheet", *(f"`{name}`" for name in METHODS)], rows)
    verdict = f"\n`footfall` slips least on {len(results) - len(worse)} of {len(results)} sheets.\n"
    return told + table + verdict + "".join(worse)


def _where_not(result: SheetResult, slips: dict[str, Floats]) -> str:
    best = min(slips, key=lambda name: p95(slips[name]))
    return (
        f"\nNot on **{_title(result)}**: `{best}` has {p95(slips[best]):.1f} mm and `{OURS}` "
        f"{p95(slips[OURS]):.1f} mm; {REASONS.get(result.name, UNKNOWN)}.\n"
    )


def p95(values: Floats) -> float:
    """Return the 95th percentile; of nothing, infinity."""
    return float(np.percentile(values, 95.0)) if len(values) else float("inf")


def detail_section(results: Sequence[SheetResult]) -> str:
    """Return one table a sheet with everything else."""
    headings = [
        "method", "slip alone", "transitions", "mixes", "drift", "mismatch",
        "stretch", "delay", "pops", "tick",
    ]  # fmt: skip
    told = (
        "\n## Every sheet\n\n"
        "Slip and drift: median / 95th percentile over support spans in mm (drift is the farthest "
        "that a carrying point comes from where it was planted). Mismatch: frames in which the "
        "feet do something else than was commanded. Stretch: mean / 95th percentile of |log2| of "
        "how much longer a phase lasts than in its clip: 1 is double or half. Delay: the longest "
        "wait of a start. Pops: 99.9th percentile of accelerations over that of the clips. Tick: "
        "processor time of 1/60 s; `equal-cycles` and `marker-leader` place their clips in Python, "
        "which is most of their time.\n"
    )
    parts = [told]
    for result in results:
        rows = [_details(name, one) for name, one in result.methods.items()]
        parts.append(f"\n### {_title(result)}\n\n{result.told}\n\n{markdown_table(headings, rows)}")
    return "".join(parts)


def _details(name: str, one: MethodResult) -> list[str]:
    report, schedule = one.report, one.schedule
    mismatch = None if report.mismatch is None else report.mismatch.overall
    ratios = report.pop_ratios
    stretch = schedule.stretch
    delays = schedule.delays
    waited = "-" if delays.maximum is None else f"{delays.maximum:.2f} s"
    if schedule.never_started:
        waited += f", {schedule.never_started} never"
    return [
        f"`{name}`",
        _spread(report.slip.alone),
        _spread(report.slip.transitions),
        _spread(report.slip.mixes),
        _spread(report.drift.overall),
        "-" if mismatch is None else f"{100.0 * mismatch:.1f} %",
        "-" if stretch.mean is None else f"{stretch.mean:.2f} / {stretch.p95:.2f}",
        waited,
        "-" if ratios is None else f"{ratios.acceleration_p999:.2f}",
        f"{one.cost:.0f} µs",
    ]


def _spread(spread: Spread) -> str:
    if spread.median is None or spread.p95 is None:
        return "-"
    return f"{spread.median:.1f} / {spread.p95:.1f}"


def overall_section(results: Sequence[SheetResult]) -> str:
    """Return what the methods cost beside slip, over all sheets."""
    rows: list[list[str]] = []
    for name in METHODS:
        ones = [result.methods[name] for result in results]
        rows.append(
            [
                f"`{name}`",
                _mean(one.report.drift.overall.p95 for one in ones),
                _mean(
                    None
                    if one.report.mismatch is None or one.report.mismatch.overall is None
                    else 100.0 * one.report.mismatch.overall
                    for one in ones
                ),
                _mean((one.schedule.stretch.mean for one in ones), 2),
                _mean((one.schedule.delays.maximum for one in ones), 2),
                str(sum(one.schedule.never_started for one in ones)),
                _mean(
                    (
                        None if one.report.pop_ratios is None
                        else one.report.pop_ratios.acceleration_p999
                        for one in ones
                    ),
                    2,
                ),
                _mean((one.cost for one in ones), 0),
            ]
        )  # fmt: skip
    headings = [
        "mean over all sheets", "drift p95 [mm]", "mismatch [%]", "stretch", "longest delay [s]",
        "never started", "pops", "tick [µs]",
    ]  # fmt: skip
    told = (
        "\n## What it costs\n\nFeet that agree are paid for: phases are stretched, and starts "
        "wait. A cross-fade pays nothing and slides.\n\n"
    )
    return told + markdown_table(headings, rows)


def _mean(values: Iterable[float | None], decimals: int = 1) -> str:
    known = [value for value in values if value is not None]
    return f"{np.mean(known):.{decimals}f}" if known else "-"


def _title(result: SheetResult) -> str:
    name = result.name.split("_", 1)[1].replace("_", " ")
    return f"{name} ({'captured' if result.captured else 'samples'})"


def pictures_section(pictures: Sequence[tuple[str, str]]) -> str:
    """Return the pictures, a title and a file each."""
    told = (
        "\n## Feet from above\n\nPrints are planted feet; a red streak is how far one slides while "
        "it should carry.\n"
    )
    return told + "".join(f"\n### {title}\n\n![{title}]({file})\n" for title, file in pictures)
