"""Figure 17 as a page: the same cues without and with synchronization."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.cli.demo_scenario import folder_scenario, sample_scenario
from footfall.cli.measuring import Comparison, compare, report_json, report_of
from footfall.cli.outputs import save_motion, write_json
from footfall.cli.staging import starts_text
from footfall.errors import FileFormatError
from footfall.io import write_atomically
from footfall.report import performance_trace, text_table
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.performance import (
    Performance,
    load_motions,
    perform,
    played_supports,
    support_text,
)
from footfall.view import (
    DemoPage,
    demo_page_html,
    foot_traces_svg,
    performance_timeline,
    timeline_svg,
    write_demo_page,
)
from footfall.warming import compiling_beside

__all__ = ["demo", "take_page"]

TAKES = (("without", "cross-fade", "Plain cross-fade"), ("with", "footfall", "footfall"))
"""Name of the file, method, and title of each take of the page."""

INTRODUCTION = (
    "The same motions, started and stopped at the same arbitrary moments: on the left faded into "
    "each other as they are, on the right with their supports synchronized and planted feet held."
)


def demo(
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))] = Path("demo"),
    motions: Path | None = None,
) -> None:
    """Write a page that shows the same cues without and with synchronization.

    Parameters
    ----------
    output
        The folder to write to; made if it is missing.
    motions
        A folder of your own motions; by default those made by the project.
    """
    if output.exists() and not output.is_dir():
        raise FileFormatError("it is a file; name a folder", path=output)
    scenario = sample_scenario() if motions is None else folder_scenario(motions)
    with compiling_beside():
        comparison = compare(scenario)
    output.mkdir(parents=True, exist_ok=True)
    _write(comparison, output)
    print(text_table(comparison.reports))
    print(starts_text(comparison.performances["footfall"]), end="")
    print(output / "index.html")


def _write(comparison: Comparison, folder: Path) -> None:
    ours = comparison.performances["footfall"]
    timeline = performance_timeline(ours)
    takes = tuple(
        (title, performance_trace(comparison.performances[method])) for _, method, title in TAKES
    )
    for name, method, _ in TAKES:
        _write_take(comparison.performances[method], folder / f"{name}.glb")
    write_atomically(folder / "timeline.svg", timeline_svg(timeline).encode())
    write_atomically(folder / "foot-traces.svg", foot_traces_svg(takes).encode())
    write_json(folder / "report.json", report_json(ours, comparison.reports))
    page = DemoPage(
        title="Feet that do not slide",
        introduction=INTRODUCTION,
        takes=takes,
        skeleton=ours.recording.skeleton,
        timeline=timeline,
        reports=comparison.reports,
    )
    write_demo_page(folder / "index.html", page)


def take_page(scenario: Scenario) -> str:
    """Return a page that plays a scenario without a network, beside what a cross-fade makes of it.

    Raises:
        ScenarioError: If it cannot be played.
    """
    motions = load_motions(scenario)
    performances = {
        "cross-fade": perform(scenario, synchronized=False, motions=motions),
        "footfall": perform(scenario, motions=motions),
    }
    page = DemoPage(
        title=scenario.path.stem,
        introduction=INTRODUCTION,
        takes=tuple((title, performance_trace(performances[method])) for _, method, title in TAKES),
        skeleton=performances["footfall"].recording.skeleton,
        timeline=performance_timeline(performances["footfall"]),
        reports={name: report_of(one) for name, one in performances.items()},
    )
    return demo_page_html(page)


def _write_take(performance: Performance, path: Path) -> None:
    clip = performance.recording.to_clip(path.stem)
    save_motion(clip, path, played_supports(performance), support_text(performance.supports))
