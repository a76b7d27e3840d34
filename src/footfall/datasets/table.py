"""The table of an archive: a row a file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path

from footfall.datasets.clip_annotation import ClipAnnotation
from footfall.io.table_files import write_parquet

__all__ = ["write_table"]

_KINDS = {"str": "string", "int": "int64", "float": "double", "bool": "bool"}


def write_table(rows: Sequence[ClipAnnotation], path: Path) -> None:
    """Write the rows as Parquet, each column of the same kind whatever is in it.

    Raises:
        FileFormatError: If the file cannot be written.
        MissingExtraError: If PyArrow is not installed.
    """
    cells = [row.to_row() for row in rows]
    names = ClipAnnotation.columns()
    types = {field.name: str(field.type).partition(" ")[0] for field in fields(ClipAnnotation)}
    write_parquet(
        {name: [row[name] for row in cells] for name in names},
        path,
        kinds={name: _KINDS[types[name]] for name in names},
    )
