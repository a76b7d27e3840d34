"""Tables in files: comma-separated text, and Parquet."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from footfall.errors import FileFormatError
from footfall.extras import extra_module
from footfall.io.atomic import write_atomically
from footfall.io.raw_file import decoded, read_bytes

__all__ = ["read_csv", "read_parquet", "write_csv", "write_parquet"]

LEAST_CELLS, CELLS_PER_BYTE = 2_000_000, 1
"""What a Parquet file may unfold to: its runs of equal cells take hardly any room."""


def read_csv(path: Path) -> dict[str, list[str]]:
    """Return the cells of a file of comma-separated values, its first line naming the columns.

    Raises:
        FileFormatError: If it cannot be read, names a column twice, or a row has not as many
            cells as there are columns.
    """
    text = decoded(read_bytes(path))
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    except csv.Error as error:
        raise FileFormatError(
            f"is no table of comma-separated values: {error}", path=path
        ) from error
    numbered = [(number, row) for number, row in enumerate(rows, start=1) if row]
    if not numbered:
        raise FileFormatError("is empty; its first line names the columns", path=path)
    names = [name.strip().lower() for name in numbered[0][1]]
    _check_names(names, path)
    for number, row in numbered[1:]:
        if len(row) != len(names):
            raise FileFormatError(
                f"has {len(row)} cells, but the first line names {len(names)} columns",
                path=path,
                line=number,
            )
    return {name: [row[index] for _, row in numbered[1:]] for index, name in enumerate(names)}


def _check_names(names: Sequence[str], path: Path) -> None:
    for name in names:
        if names.count(name) > 1:
            raise FileFormatError(f"names the column {name[:40]!r} twice", path=path, line=1)


def write_csv(columns: Mapping[str, Sequence[Any]], path: Path) -> None:
    """Write a table as comma-separated values; numbers so that they are read back exactly.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    for row in zip(*columns.values(), strict=True):
        writer.writerow([_cell(cell) for cell in row])
    write_atomically(path, text.getvalue().encode())


def _cell(cell: Any) -> Any:
    if isinstance(cell, bool):
        return "true" if cell else "false"
    return repr(float(cell)) if isinstance(cell, float) else cell


def read_parquet(path: Path) -> dict[str, list[Any]]:
    """Return the cells of a Parquet file.

    Raises:
        FileFormatError: If it cannot be read, or unfolds to far more than its size.
        MissingExtraError: If PyArrow is not installed.
    """
    parquet = extra_module("pyarrow.parquet", f"reading {path.name}", extra="tables")
    arrow = extra_module("pyarrow", f"reading {path.name}", extra="tables")
    data = read_bytes(path)
    try:
        file = parquet.ParquetFile(arrow.BufferReader(data))
        facts = file.metadata
        cells = facts.num_rows * facts.num_columns
        if cells > LEAST_CELLS + CELLS_PER_BYTE * len(data):
            raise FileFormatError(
                f"unfolds to {facts.num_rows} rows of {facts.num_columns} columns, far more than "
                "such a file holds",
                path=path,
            )
        table = file.read(use_threads=False)
        columns: dict[str, list[Any]] = {}
        _check_names([str(name).lower() for name in table.column_names], path)
        for name in table.column_names:
            columns[str(name).lower()] = table.column(name).to_pylist()
    except FileFormatError:
        raise
    except (arrow.ArrowException, OSError, ValueError, TypeError, OverflowError) as error:
        told = " ".join(str(error).split())[:120]
        raise FileFormatError(f"is damaged or no Parquet file: {told}", path=path) from error
    return columns


def write_parquet(
    columns: Mapping[str, Sequence[Any]], path: Path, *, kinds: Mapping[str, str] | None = None
) -> None:
    """Write a table as Parquet; the same columns give the same bytes.

    Args:
        columns: The cells by the names of the columns.
        path: The file.
        kinds: What each column holds, by Arrow's names: string, int64, double or bool; found out
            from the cells where not given.

    Raises:
        FileFormatError: If the file cannot be written.
        MissingExtraError: If PyArrow is not installed.
    """
    parquet = extra_module("pyarrow.parquet", f"writing {path.name}", extra="tables")
    arrow = extra_module("pyarrow", f"writing {path.name}", extra="tables")
    buffer = io.BytesIO()
    arrays = {
        name: arrow.array(list(cells), None if kinds is None else arrow.type_for_alias(kinds[name]))
        for name, cells in columns.items()
    }
    parquet.write_table(arrow.table(arrays), buffer)
    write_atomically(path, buffer.getvalue())
