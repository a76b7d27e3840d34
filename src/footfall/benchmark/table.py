"""The table of costs: each figure beside its budget."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass

from footfall.benchmark.adapting import adaptation_rows
from footfall.benchmark.crowds import crowd_rows
from footfall.benchmark.processes import process_rows
from footfall.benchmark.references import reference_rows
from footfall.benchmark.rows import Row

__all__ = ["Row", "measure_all", "rows_json", "table_text"]


@dataclass(frozen=True)
class _Kind:
    """Figures that are measured together."""

    words: str
    measure: Callable[[], list[Row]]


KINDS = (
    _Kind("the reference work, by four ways", reference_rows),
    _Kind("crowds", crowd_rows),
    _Kind("adaptation beside the rest of a tick", adaptation_rows),
    _Kind("processes: import, cache, cold compile", process_rows),
)


def measure_all(tell: Callable[[str], None]) -> list[Row]:
    """Measure every figure.

    Args:
        tell: Is told in one line what is measured next.
    """
    rows: list[Row] = []
    for kind in KINDS:
        tell(f"measuring {kind.words} ...")
        rows += kind.measure()
    return rows


def table_text(rows: list[Row]) -> str:
    """Return the rows as a table; a star is where a budget is not met."""
    lines = [f"{'what':26}{'value':>12}{'budget':>12}  unit"]
    for row in rows:
        budget = "" if row.budget is None else f"{row.budget:.3g}"
        lines.append(f"{row.name:26}{row.value:12.4g}{budget:>12}{row.mark} {row.unit}")
    return "\n".join(lines)


def rows_json(rows: list[Row]) -> str:
    """Return the rows as one line of JSON."""
    fields = [
        {"name": row.name, "value": row.value, "budget": row.budget, "unit": row.unit}
        for row in rows
    ]
    return json.dumps({"rows": fields})
