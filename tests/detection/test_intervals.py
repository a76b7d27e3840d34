from __future__ import annotations

import numpy as np

from footfall.detection.intervals import Interval, covers, runs, without_short_ones


def test_runs_are_where_flags_are_set() -> None:
    flags = np.array([True, True, False, True, False, False, True])
    assert runs(flags) == [(0, 2), (3, 4), (6, 7)]
    assert runs(np.zeros(3, dtype=np.bool_)) == []


def test_a_short_gap_is_closed_before_a_short_interval_is_dropped() -> None:
    found = [Interval(0.0, 0.04, 0.3, 0.4), Interval(0.05, 0.09, 0.5, 0.6), Interval(0.5, 0.53)]
    kept = without_short_ones(found, 0.06, 1.0, cyclic=False)
    assert kept == (Interval(0.0, 0.09, 0.3, 0.6),)


def test_a_short_gap_over_the_end_of_a_cycle_is_closed() -> None:
    found = [Interval(0.02, 0.4), Interval(0.6, 0.98)]
    assert without_short_ones(found, 0.06, 1.0, cyclic=True) == (Interval(0.6, 1.4),)
    assert without_short_ones(found, 0.06, 1.0, cyclic=False) == tuple(found)


def test_one_interval_that_nearly_closes_a_cycle_is_all_of_it() -> None:
    assert without_short_ones([Interval(0.3, 1.27)], 0.06, 1.0, cyclic=True) == (
        Interval(0.0, 1.0),
    )


def test_times_in_an_interval_are_covered_over_the_end_of_a_cycle_too() -> None:
    times = np.array([0.0, 0.3, 0.7, 0.9, 1.0])
    interval = (Interval(0.8, 1.2),)
    assert covers(interval, times, 1.0, cyclic=True).tolist() == [True, False, False, True, True]
    assert covers(interval, times, 1.0, cyclic=False).tolist() == [
        False,
        False,
        False,
        True,
        True,
    ]
