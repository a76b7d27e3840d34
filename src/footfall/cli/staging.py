"""Play a cue sheet and measure what comes out: `blend` and `report`."""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from footfall.cli.inputs import about, origin_of, read_motion
from footfall.cli.measuring import compare, motion_report, report_json
from footfall.cli.outputs import check_folder, check_output, save_motion, write_json
from footfall.detection import detect_supports, frame_symbols
from footfall.report import text_table
from footfall.scenario.cue_sheet import Scenario, load_scenario
from footfall.scenario.motions import Motion
from footfall.scenario.performance import Performance, perform, played_supports, support_text

__all__ = ["blend", "report", "starts_text"]


def blend(
    scenario: Path,
    /,
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))],
    sync: Annotated[bool, Parameter(negative="--no-sync")] = True,
    footprints: Annotated[bool, Parameter(negative="--no-footprints")] = True,
    report_file: Annotated[Path | None, Parameter(name="--json")] = None,
) -> None:
    """Play a cue sheet and write the motion.

    Parameters
    ----------
    scenario
        The .toml cue sheet.
    output
        The .bvh, .glb or .npz file to write; its .supports go beside it.
    sync
        Whether supports are synchronized.
    footprints
        Whether planted feet are held where they came down.
    report_file
        Measure the same cues by every method, and write the figures to this file.
    """
    check_output(output)
    if report_file is not None:
        check_folder(report_file)
    sheet = load_scenario(scenario)
    performance = perform(sheet, synchronized=sync, footprints=footprints)
    figures = None if report_file is None else _figures(performance, sheet)
    clip = performance.recording.to_clip(scenario.stem)
    symbols = support_text(performance.supports)
    save_motion(clip, output, played_supports(performance), symbols)
    if report_file is not None and figures is not None:
        write_json(report_file, figures)
    print(f"{output}: {clip.frames} frames, {clip.duration:.3f} s")
    print(starts_text(performance), end="")


def _figures(performance: Performance, sheet: Scenario) -> dict[str, Any]:
    return report_json(performance, compare(sheet).reports)


def starts_text(performance: Performance) -> str:
    """Return one line a start command: when it came about, and why it waited."""
    lines: list[str] = []
    for start in performance.starts:
        told = f"  {start.action}: commanded at {start.commanded:.2f} s, "
        if start.actual is None:
            told += f"never started: {start.reason}"
        elif start.reason:
            told += f"started at {start.actual:.2f} s: {start.reason}"
        else:
            told += "started at once"
        if start.muted > 0.0:
            told += f"; {start.muted:.2f} s of it muted, without its legs"
        lines.append(told + "\n")
    return "".join(lines)


def report(file: str, /, *, json: bool = False) -> None:
    """Measure a motion, or a cue sheet by every method.

    Parameters
    ----------
    file
        A .bvh, .bvh.gz or .npz file, sample:NAME, or a .toml cue sheet. A motion's .supports
        beside it are used; else supports are detected.
    json
        Print JSON.
    """
    if file.endswith(".toml"):
        comparison = compare(load_scenario(file))
        ours = comparison.performances["footfall"]
        if json:
            print(json_text.dumps(report_json(ours, comparison.reports), indent=2))
            return
        print(text_table(comparison.reports))
        print(starts_text(ours), end="")
        return
    clip, known = read_motion(file)
    with about(file):
        supports = detect_supports(clip) if known is None else known
        row = motion_report(Motion(clip, supports))
    if json:
        figures: dict[str, Any] = {
            "fps": clip.fps,
            "frames": clip.frames,
            "supports": frame_symbols(supports, clip.fps, clip.frames),
            "detected": known is None,
            "starts": [],
            "rows": {"clip": row.to_json()},
        }
        print(json_text.dumps(figures, indent=2))
        return
    print(f"{file}: supports {origin_of(known)}: {supports}")
    print(text_table({"clip": row}))
