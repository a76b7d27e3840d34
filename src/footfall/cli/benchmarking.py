"""What the engine costs on this machine: `bench`."""

from __future__ import annotations

import sys
from pathlib import Path

from footfall.io.atomic import write_atomically

__all__ = ["bench"]


def bench(*, plot: Path | None = None, json: bool = False) -> None:
    """Measure what the engine costs on this machine, beside its budgets.

    Takes some minutes: crowds of up to 50 000 characters, and kernels compiled anew.

    Parameters
    ----------
    plot
        Also draw the cost against characters and actions, as an SVG file.
    json
        Print the table as one line of JSON after all.
    """
    from footfall.benchmark import measure_all, rows_json, table_text

    rows = measure_all(lambda words: print(words, file=sys.stderr, flush=True))
    print(table_text(rows))
    if plot is not None:
        from footfall.benchmark.picture import cost_picture, measure_costs

        write_atomically(plot, cost_picture(*measure_costs()).encode())
    if json:
        print(rows_json(rows))
