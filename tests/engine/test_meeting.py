"""Goals of many: by row and by mask, with arrays of points, and as of one character alone."""

from __future__ import annotations

import numpy as np
import pytest
from tests.engine.test_cohorts import ROBOT, scaled

import footfall as ff
from footfall.arrays import Floats
from footfall.errors import ArgumentError

DT = 1.0 / 60.0


@pytest.fixture(scope="module")
def library() -> ff.MotionLibrary:
    library = ff.MotionLibrary()
    for name in ("walk", "idle"):
        library.add(name, *ff.sample(name))
    return library


def hand(crowd: ff.Crowd, row: int) -> Floats:
    """Return where the left wrist of a row is [m]."""
    arm = crowd.library.anatomy.arms[0]
    assert arm is not None
    return crowd.world_positions[row, arm.wrist].copy()


def test_each_hand_comes_to_its_own_point(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 10)
    crowd.start(1)
    crowd.advance(0.0)
    rows = np.array([2, 5, 9])
    points = np.array([hand(crowd, row) for row in rows])
    points += np.array([0.0, 0.2, 0.2])
    points[:, 1] += np.array([0.0, 0.05, 0.1])
    free = hand(crowd, 3)
    crowd.goals.reach("left", points, rows)
    for _ in range(40):
        crowd.advance(DT)
    for row, point in zip(rows, points, strict=True):
        assert hand(crowd, row) == pytest.approx(point, abs=1e-6)
    assert np.abs(hand(crowd, 3) - free).max() < 0.05
    assert crowd.goals.unreached == ()
    mask = np.zeros(10, dtype=np.bool_)
    mask[5] = True
    crowd.goals.reach("left", points[1] + [0.0, 0.0, 3.0], mask)
    for _ in range(60):
        crowd.advance(DT)
    (far,) = crowd.goals.unreached
    assert (far.name, far.row) == ("left hand", 5)
    assert far.missed == pytest.approx(crowd.goals.missed[5, 0])


def test_each_row_meets_its_goals_as_the_character_alone(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 11)
    child = int(crowd.spawn(3, body=scaled(0.6))[1])
    robot = int(crowd.spawn(3, body=ROBOT)[2])
    alone = {
        4: ff.Crowd(library, 1),
        child: ff.Crowd(library, 1, skeleton=scaled(0.6)),
        robot: ff.Crowd(library, 1, skeleton=ROBOT),
    }
    for frame in range(120):
        for row, single in alone.items():
            for one, rows in ((crowd, [row]), (single, [0])):
                point = (0.2, 0.8 + 0.002 * frame, 0.01 * frame)
                if frame == 0:
                    one.start(0, rows)
                if frame >= 10:
                    one.goals.look_at(point, rows)
                if frame == 20:
                    one.goals.join_hands(0.1, rows)
                if frame == 50:
                    one.goals.reach("right", point, rows, weight=0.7, fade=0.5)
                if frame == 70:
                    one.goals.sit(0.4, rows)
                    one.reach("left", point, rows)
                if frame == 90:
                    one.goals.drop("gaze", rows)
                    one.goals.drop("seat", rows, fade=0.0)
        crowd.goals.sit(0.6, [0, 1, 2, 3, 5])
        crowd.advance(DT)
        for row, single in alone.items():
            single.advance(DT)
            cohort = next(one for one in crowd.cohorts if row in one.rows)
            place = row - cohort.span.first
            assert np.array_equal(cohort.world_rotations[place], single.world_rotations[0])
            assert np.array_equal(crowd.goals.missed[row], single.goals.missed[0])


def test_a_newborn_has_no_goal_of_who_was_there_before(library: ff.MotionLibrary) -> None:
    crowd, fresh = ff.Crowd(library, 3), ff.Crowd(library, 3)
    crowd.goals.look_at((5.0, 0.0, 0.0))
    crowd.goals.join_hands(0.0)
    crowd.reach("right", (0.0, 1.0, 1.0))
    for _ in range(30):
        crowd.advance(DT)
    crowd.remove([1])
    assert crowd.spawn(2).tolist() == [1, 3]
    crowd.advance(0.0)
    fresh.advance(0.0)
    for row in (1, 3):
        assert np.array_equal(crowd.world_rotations[row], fresh.world_rotations[0])
    assert crowd.hand("right", 1).task == "free"


def test_goals_for_nobody_and_points_that_are_none_are_refused(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 3)
    with pytest.raises(ArgumentError, match=r"^rows 1..7; this crowd has rows 0..2$"):
        crowd.goals.reach("left", (0.0, 1.0, 0.0), [1, 7])
    with pytest.raises(ArgumentError, match=r"it must be three finite numbers, for all or for ea"):
        crowd.goals.look_at(np.zeros((2, 3)))
    with pytest.raises(
        ArgumentError,
        match=r"^the height of the seat is nan; it must be a finite number, for all or f",
    ):
        crowd.goals.sit(float("nan"))
    assert not crowd.goals.missed.any()
    crowd.advance(DT)
    assert not crowd.goals.memory["progress"].any()
