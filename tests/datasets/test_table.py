from __future__ import annotations

from pathlib import Path

import pytest

from footfall.datasets import ClipAnnotation
from footfall.datasets.table import write_table


@pytest.mark.parametrize(
    "rows", [[], [ClipAnnotation("a.bvh", 1, 2, error="no")], [ClipAnnotation("a", 1, 2, frames=3)]]
)
def test_a_column_is_of_one_kind_whatever_is_in_it(
    tmp_path: Path, rows: list[ClipAnnotation]
) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    write_table(rows, tmp_path / "table.parquet")
    table = parquet.read_table(tmp_path / "table.parquet")
    kinds = {name: str(table.schema.field(name).type) for name in table.column_names}
    assert tuple(kinds) == ClipAnnotation.columns()
    assert {kinds[name] for name in ("file", "error", "supports", "unit")} == {"string"}
    assert {kinds[name] for name in ("frames", "size", "changed", "spans")} == {"int64"}
    assert {kinds[name] for name in ("fps", "slip_p95_mm", "floor_mm")} == {"double"}
    assert kinds["cyclic"] == "bool"
    assert table.to_pylist() == [row.to_row() for row in rows]
