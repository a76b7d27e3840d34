"""Schedules of the default planner as pictures: a change of the planner is a change of these."""

from __future__ import annotations

from pathlib import Path

import pytest

from footfall.scenario.schedule_fields import ScheduleProblem
from footfall.scenario.schedule_problem import describe_problem

GOLDEN = Path(__file__).parents[1] / "golden" / "schedules"
WALK, RUN, HOP = "R.4 D.14 L.4 D.14*", "R.2 -.14 L.2 -.14*", "R.28 -.24*"
PROBLEMS: dict[str, tuple[tuple[str, ...], tuple[int, ...]]] = {
    "walk_and_run": ((WALK, RUN), (0, 2)),
    "walk_and_right_hop": ((WALK, HOP), (0, 1)),
    "walk_and_kick": ((WALK, "D.35 L.75 D.45"), (0, 1)),
    "walk_and_shot": ((WALK, "L.22 D.1 R.24 -.38 L.3 D.2"), (0, 0)),
    "right_hop_and_left_hop": ((HOP, "L.28 -.24*"), (0, 0)),
    "walk_run_and_jump": ((WALK, RUN, "D.55 -.42 D.6"), (0, 2, 5)),
    "trot_and_gallop": (
        ("L+r.26 -.04 R+l.26 -.04*", "L.08 D.06 R+l.07 +lr.07 +r.06 -.14*"),
        (0, 1),
    ),
}


@pytest.mark.parametrize("name", PROBLEMS)
def test_schedule(name: str) -> None:
    sequences, start = PROBLEMS[name]
    count = len(sequences)
    priorities = tuple(float(count - i) for i in range(count))
    problem = ScheduleProblem(sequences, priorities, start, slots=16)
    assert describe_problem(problem) + "\n" == (GOLDEN / f"{name}.txt").read_text()
