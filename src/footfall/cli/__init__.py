"""The commands: a documented function each.

What is wrong with the input is told in one line on stderr, with exit code 2 and nothing written.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from cyclopts import App, CycloptsError

from footfall.cli.annotating import annotate
from footfall.cli.benchmarking import bench
from footfall.cli.converting import convert
from footfall.cli.demonstration import demo
from footfall.cli.drawing import figures
from footfall.cli.fetching import fetch_samples, list_samples
from footfall.cli.inspection import detect, info
from footfall.cli.making import clean, edit
from footfall.cli.retargeting import retarget
from footfall.cli.robotics import robot, robot_model
from footfall.cli.scheduling import sync
from footfall.cli.staging import blend, report
from footfall.cli.studio import studio
from footfall.errors import FootfallError

__all__ = [
    "annotate",
    "bench",
    "blend",
    "clean",
    "convert",
    "demo",
    "detect",
    "edit",
    "fetch_samples",
    "figures",
    "info",
    "list_samples",
    "main",
    "report",
    "retarget",
    "robot",
    "robot_model",
    "studio",
    "sync",
]

WRONG = 2
"""Exit code where something was wrong with the input."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Args:
        arguments: The words after ``footfall``; None: those of the command line.

    Returns:
        The exit code: 0, or 2 where something was wrong with the input.
    """
    app = App(
        name="footfall",
        help="Starts, stops and mixes motion clips so that the feet never slide.",
        version_flags=[],
    )
    for command in (
        info,
        detect,
        edit,
        clean,
        convert,
        retarget,
        sync,
        blend,
        report,
        annotate,
        robot,
        robot_model,
        demo,
        figures,
        studio,
        bench,
    ):
        app.command(command)
    samples = App(name="samples", help="Motions that others have published.", version_flags=[])
    samples.command(list_samples, name="list")
    samples.command(fetch_samples, name="fetch")
    app.command(samples)
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        app(words, exit_on_error=False, print_error=False, result_action="return_value")
    except (FootfallError, CycloptsError, OSError) as error:
        print(f"footfall: {_one_line(error)}", file=sys.stderr)
        return WRONG
    return 0


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
