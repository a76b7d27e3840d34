"""What the engine costs on this machine, beside its budgets. A leaf: nothing imports it."""

from footfall.benchmark.table import Row, measure_all, rows_json, table_text

__all__ = ["Row", "measure_all", "rows_json", "table_text"]
