"""Schedule problems: sequences of symbols in, who plays which phase when out.

One problem is a JSON object on a line,

    {"sequences": ["R D L D*", "L D - D L"], "start": [0, 2], "slots": 24, "planner": "paper"}

and its answer another one. A problem that cannot be read gets an answer with only `error`.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any, cast

import numpy as np

from footfall.arrays import Seconds
from footfall.errors import FootfallError, ScenarioError
from footfall.scenario.schedule_fields import ScheduleProblem, parse_timed
from footfall.scenario.schedule_run import play_commands
from footfall.support import Support
from footfall.sync.synchronizer import Synchronizer
from footfall.sync.tables import ABSENT, SequenceTable
from footfall.sync.window import Window

__all__ = ["ScheduleProblem", "describe_problem", "solve", "solve_batch", "solve_problem"]


def solve_problem(text: str) -> dict[str, Any]:
    """Answer one line: a problem in JSON.

    Args:
        text: The JSON object.

    Returns:
        The answer: `result`, `rows`, `started`, `durations`, `muted` and `error`; only `error`
        if the problem cannot be read.
    """
    try:
        fields: Any = json.loads(text)
        if not isinstance(fields, dict):
            raise ScenarioError('a problem is a JSON object, such as {"sequences": ["R D L D*"]}')
        return solve(ScheduleProblem.of(cast(dict[str, Any], fields)))
    except json.JSONDecodeError as error:
        return {"error": f"not JSON at column {error.colno}: {error.msg}"}
    except FootfallError as error:
        return {"error": str(error)}


def solve_batch(lines: Iterable[str]) -> Iterator[str]:
    """Answer one problem a line, in the same order; empty lines are passed over."""
    for line in lines:
        if line.strip():
            yield _ENCODER.encode(solve_problem(line))


def solve(problem: ScheduleProblem) -> dict[str, Any]:
    """Play a problem and return its answer, ready for JSON."""
    rules = problem.rules
    table = _table(problem.sequences)
    count = len(problem.sequences)
    window = Window.empty(count, problem.lookahead)
    window.sequence[:] = range(count)
    window.priority[:] = problem.priorities
    window.weight[:] = problem.priorities
    started = np.full(count, ABSENT, dtype=np.int64)
    own = np.empty((count, problem.slots), dtype=np.int64)
    muted = np.zeros((count, problem.slots), dtype=np.bool_)
    results = np.empty(problem.slots, dtype=np.int64)
    durations = np.empty(problem.slots)
    played = play_commands(
        table,
        window,
        rules,
        np.array(problem.order, dtype=np.int64),
        np.array(problem.start, dtype=np.int64),
        started,
        own,
        muted,
        results,
        durations,
        np.empty(count),
        np.empty(count),
    )
    rows = [[None if index < 0 else index for index in row] for row in own[:, :played].tolist()]
    symbols = [_SYMBOLS[result] for result in results[:played].tolist()]
    failed = symbols[-1] == _SYMBOLS[Support.CONFLICT]
    timed = all(parse_timed(text)[1] for text in problem.sequences)
    return {
        "result": symbols,
        "rows": rows,
        "started": [None if slot == ABSENT else slot for slot in started.tolist()],
        "durations": _seconds(durations[:played]) if timed else None,
        "muted": muted[:, :played].tolist() if muted[:, :played].any() else None,
        "error": _failure(problem, rows) if failed else None,
    }


def describe_problem(problem: ScheduleProblem, *, trace: bool = False) -> str:
    """Play a problem and return its schedule as text, with why anything waited.

    Args:
        problem: What to play.
        trace: Whether to write everything, as `Schedule.describe` does, instead of the table.
    """
    sequences = [parse_timed(text)[0] for text in problem.sequences]
    names = [
        " ".join(phase.support.symbol for phase in one.phases) + "*" * one.cyclic
        for one in sequences
    ]
    synchronizer = Synchronizer(
        sequences,
        problem.priorities,
        names=names,
        lookahead=problem.lookahead,
        planner=problem.planner,
        start_policy=problem.start_policy,
        ended=problem.ended,
    )
    remarks: list[str] = []
    for slot in range(problem.slots):
        if slot > 0:
            synchronizer.next_slot()
        if synchronizer.result is Support.CONFLICT:
            break
        commanded = [i for i in problem.order if problem.start[i] == slot]
        refused = [i for i in commanded if not synchronizer.start(i)]
        remarks += [f"slot {slot}: {names[i]!r} {synchronizer.waiting[i]}" for i in refused]
    played = synchronizer.trace
    lines = [played.describe()] if trace else [str(played), *remarks]
    if played.results[-1] is Support.CONFLICT:
        lines.append(_failure(problem, [list(row.phases) for row in played.rows]))
    return "\n".join(lines)


_ENCODER = json.JSONEncoder(ensure_ascii=False)
_SYMBOLS = {int(support): support.symbol for support in Support}


@lru_cache(maxsize=1024)
def _table(texts: tuple[str, ...]) -> SequenceTable:
    return SequenceTable.of([parse_timed(text)[0] for text in texts])


def _seconds(durations: Seconds) -> list[float | None]:
    """Return the slots' durations; None where nobody plays, or nothing can be played."""
    values: list[float] = durations.tolist()
    return [None if math.isnan(one) else one for one in values]


def _failure(problem: ScheduleProblem, rows: list[list[int | None]]) -> str:
    """Say in which slot the rule failed: the last one, and between whom."""
    feet: dict[Support, int] = {}
    for i, row in enumerate(rows):
        index = row[-1]
        if index is not None:
            feet.setdefault(parse_timed(problem.sequences[i])[0].phases[index].support, i)
    return (
        f"the rule fails in slot {len(rows[0]) - 1}: sequence {feet[Support.RIGHT]} stands on R "
        f"and sequence {feet[Support.LEFT]} on L, and one of them has ended and cannot give way"
    )
