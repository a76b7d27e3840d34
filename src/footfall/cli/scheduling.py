"""Schedules of symbols: `sync`."""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter

from footfall.errors import ArgumentError, FileFormatError
from footfall.scenario.schedule_problem import (
    ScheduleProblem,
    describe_problem,
    solve,
    solve_batch,
)

__all__ = ["sync"]


def sync(
    *sequences: Annotated[str, Parameter(allow_leading_hyphen=True)],
    start: str | None = None,
    slots: int = 12,
    lookahead: int = 5,
    planner: Literal["footfall", "paper"] = "footfall",
    batch: Path | None = None,
    trace: bool = False,
    json: bool = False,
) -> None:
    """Synchronize sequences of supports, such as "R D L D*" "L D - D L".

    Parameters
    ----------
    sequences
        R, L, D and - separated by blanks, each with its seconds if wanted; * at the end for
        cyclic. The first has the highest priority.
    start
        The slot of each start command, such as 0,1.
    slots
        How many slots are played.
    lookahead
        How many slots ahead are decided.
    planner
        The default planner, or the paper's rule.
    batch
        Answer this file instead: a JSON problem a line in, a JSON answer a line out.
    trace
        Print all that was decided: seconds of each slot, how many times as long as at its own speed
        each phase lasts, who is held or muted, and why a start waits.
    json
        Print JSON.
    """
    if trace and (json or batch is not None):
        raise ArgumentError("--trace prints text; give neither --json nor --batch beside it")
    if batch is not None:
        if sequences:
            raise ArgumentError("--batch reads its sequences from the file; give none beside it")
        for answer in solve_batch(_lines(batch)):
            print(answer)
        return
    if not sequences:
        raise ArgumentError('no sequences; give at least one, such as "R D L D*", or --batch FILE')
    fields: dict[str, Any] = {
        "sequences": list(sequences),
        "slots": slots,
        "lookahead": lookahead,
        "planner": planner,
    }
    if start is not None:
        fields["start"] = _slots(start)
    problem = ScheduleProblem.of(fields)
    if json:
        print(json_text.dumps(solve(problem), ensure_ascii=False))
    else:
        print(describe_problem(problem, trace=trace))


def _lines(path: Path) -> list[str]:
    try:
        return path.read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        raise FileFormatError("there is no such file; check the name", path=path) from None
    except UnicodeDecodeError as error:
        raise FileFormatError(f"not UTF-8 text at byte {error.start}", path=path) from None


def _slots(text: str) -> list[int]:
    try:
        return [int(word) for word in text.split(",")]
    except ValueError:
        raise ArgumentError(f"--start is {text!r}; it must be slot numbers such as 0,1") from None
