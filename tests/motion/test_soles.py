from __future__ import annotations

import numpy as np
import pytest
from tests.report.bodies import ANATOMY, FOOT_LENGTH, HEEL, LEFT, RIGHT, TOE, resting_feet, trace_of

import footfall as ff
from footfall.arrays import Positions, Rotations
from footfall.geometry import from_axis_angle, multiply, rotate
from footfall.motion import with_soles
from footfall.motion.soles import HEEL_SHARE
from footfall.skeleton import FootPoint, find_anatomy

ANKLE_HEIGHT = 0.08


def standing(frames: int = 10) -> tuple[Rotations, Positions]:
    """Return a body whose ankles are over its soles: toes on the ground, heels nowhere."""
    points = resting_feet(frames)
    points[:, :, HEEL, 1] = ANKLE_HEIGHT
    trace = trace_of(points, "D" * frames)
    return np.array(trace.rotations), np.array(trace.positions)


def heel_offset(rotations: Rotations, positions: Positions, foot: int) -> tuple[float, ...]:
    return with_soles(ANATOMY, rotations, positions).legs[foot].heel.offset


@pytest.mark.parametrize("foot", [LEFT, RIGHT])
def test_the_heel_is_level_with_the_toe_and_behind_the_ankle(foot: int) -> None:
    offset = heel_offset(*standing(), foot)
    assert offset == pytest.approx([0.0, -ANKLE_HEIGHT, -HEEL_SHARE * FOOT_LENGTH])


def test_frames_in_which_the_ankle_is_up_do_not_count() -> None:
    rotations, positions = standing()
    on_tiptoe = from_axis_angle(np.array([1.0, 0.0, 0.0]), np.array(0.8))
    ankle, toe = ANATOMY.left.ankle, ANATOMY.left.toe.joint
    rotations[3:, ankle] = on_tiptoe
    positions[3:, ankle] = positions[3:, toe] + rotate(
        on_tiptoe, positions[0, ankle] - positions[0, toe]
    )
    expected = heel_offset(*standing(), LEFT)
    assert heel_offset(rotations, positions, LEFT) == pytest.approx(expected)


def test_it_does_not_depend_on_how_the_body_is_turned() -> None:
    rotations, positions = standing()
    turn = from_axis_angle(np.array([0.0, 1.0, 0.0]), np.array(1.1))
    found = heel_offset(multiply(turn, rotations), rotate(turn, positions), LEFT)
    assert found == pytest.approx(heel_offset(rotations, positions, LEFT))


def test_a_heel_of_its_own_stays_and_so_does_a_foot_without_toe() -> None:
    rotations, positions = standing()
    own = FootPoint(ANATOMY.left.ankle, (0.0, -0.07, -0.05))
    bare = FootPoint(ANATOMY.right.ankle, (0.0, 0.0, 0.0))
    anatomy = type(ANATOMY)(
        left=type(ANATOMY.left)(1, 2, 3, own, ANATOMY.left.toe),
        right=type(ANATOMY.right)(5, 6, 7, bare, bare),
        parts=ANATOMY.parts,
        reasons=(),
    )
    found = with_soles(anatomy, rotations, positions)
    assert found.left.heel == own
    assert found.right.heel == bare


def test_a_foot_that_points_straight_down_has_no_sole() -> None:
    rotations, positions = standing()
    toe = ANATOMY.left.toe.joint
    positions[:, toe] = positions[:, ANATOMY.left.ankle] - [0.0, FOOT_LENGTH, 0.0]
    assert with_soles(ANATOMY, rotations, positions).left == ANATOMY.left


def test_the_heel_of_a_walk_stands_still_while_it_carries() -> None:
    walk, _ = ff.sample("walk")
    rotations, positions = walk.world_poses()
    leg = with_soles(find_anatomy(walk.skeleton), rotations, positions).left
    heel = positions[:, leg.ankle] + rotate(rotations[:, leg.ankle], np.array(leg.heel.offset))
    lowest = heel[:, 1] < heel[:, 1].min() + 0.004
    moved = np.linalg.norm(np.diff(heel[:, [0, 2]], axis=0), axis=-1)[lowest[1:] & lowest[:-1]]
    assert lowest.sum() > 10
    assert moved.max() < 0.003
    assert heel[:, TOE].min() > -0.03
