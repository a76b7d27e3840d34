from __future__ import annotations

from footfall.report import Group, GroupedSpread, Spread


def test_a_spread_has_median_p95_and_maximum() -> None:
    assert Spread.of(range(101)) == Spread(101, 50.0, 95.0, 100.0)


def test_nothing_has_no_figures() -> None:
    assert Spread.of([]).to_json() == {"median": None, "p95": None, "max": None, "count": 0}


def test_groups_stand_apart_and_all_together() -> None:
    spread = GroupedSpread.of([(Group.ALONE, 1.0), (Group.MIXES, 5.0), (Group.ALONE, 3.0)])
    assert spread == GroupedSpread(
        overall=Spread(3, 3.0, 4.8, 5.0),
        alone=Spread(2, 2.0, 2.9, 3.0),
        transitions=Spread(0, None, None, None),
        mixes=Spread(1, 5.0, 5.0, 5.0),
    )
