from __future__ import annotations

from tests.report.bodies import resting_feet, trace_of
from tests.report.test_summary import GOLDEN, staged_report

from footfall.report import METHODS, measure, text_table


def test_the_table_is_the_one_kept() -> None:
    still = measure(trace_of(resting_feet(30), "L" * 30))
    table = text_table({"footfall": still, "clips": still, "cross-fade": staged_report()})
    assert table + "\n" == (GOLDEN / "table.txt").read_text()


def test_the_methods_stand_in_their_order_whatever_the_mapping_says() -> None:
    report = measure(trace_of(resting_feet(30), "L" * 30))
    table = text_table(dict.fromkeys((*reversed(METHODS), "clips"), report))
    assert [line.split()[0] for line in table.splitlines()[2:-1]] == [*METHODS, "clips"]
