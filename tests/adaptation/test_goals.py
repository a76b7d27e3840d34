"""Goals met on a finished pose."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.paper.requirements import requirement
from tests.skeleton.bodies import body
from tests.walking_figure import walk

from footfall.adaptation.goal_body import goal_body_of
from footfall.arrays import Positions, Rotations
from footfall.engine.goal_setting import Goals
from footfall.engine.state import new_characters
from footfall.errors import ArgumentError, UnknownNameError
from footfall.geometry import rotate
from footfall.skeleton import Skeleton, find_anatomy

DT = 1.0 / 60.0
WALK = walk(frames=40, fps=30.0)
BODY = WALK.skeleton
ANATOMY = find_anatomy(BODY)
ROTATIONS, POSITIONS = WALK.world_poses()
LEFT, RIGHT, HEAD = BODY.index("LeftHand"), BODY.index("RightHand"), BODY.index("Head")
IN_REACH = (0.3, 1.3, 0.4)


def posed(goals: Goals, frames: int = 60, frame: int = 0) -> tuple[Rotations, Positions]:
    """Return a pose after so many steps of time, and whether its bones keep their lengths."""
    rotations, positions = ROTATIONS[frame].copy(), POSITIONS[frame].copy()
    for _ in range(frames):
        rotations, positions = ROTATIONS[frame].copy(), POSITIONS[frame].copy()
        goals.meet(slice(0, 1), rotations[np.newaxis], positions[np.newaxis], DT)
    for joint in range(1, BODY.count):
        parent = int(BODY.parents[joint])
        expected = positions[parent] + rotate(rotations[parent], BODY.rest_offsets[joint])
        np.testing.assert_allclose(positions[joint], expected, atol=1e-6)
    return rotations, positions


def goals(skeleton: Skeleton = BODY) -> Goals:
    """Return the goals of one character that faces +z."""
    mine, nobody = Goals(), np.zeros(1, dtype=np.int64)
    mine.make_room(new_characters(1, 5), [goal_body_of(skeleton, find_anatomy(skeleton))], nobody)
    return mine


def test_without_goals_a_pose_stays_as_it_is() -> None:
    rotations, positions = posed(goals())
    np.testing.assert_array_equal(positions, POSITIONS[0])
    np.testing.assert_array_equal(rotations, ROTATIONS[0])


def test_a_hand_comes_to_its_goal_and_leaves_it_again() -> None:
    mine = goals()
    mine.reach("left", IN_REACH)
    _, positions = posed(mine)
    np.testing.assert_allclose(positions[LEFT], IN_REACH, atol=1e-6)
    assert mine.unreached == ()
    mine.drop("left hand")
    _, positions = posed(mine)
    np.testing.assert_allclose(positions[LEFT], POSITIONS[0, LEFT], atol=1e-9)


def test_a_goal_fades_in_without_a_jump() -> None:
    mine = goals()
    mine.reach("left", IN_REACH, fade=0.5)
    path = [POSITIONS[0, LEFT], *(posed(mine, 1)[1][LEFT] for _ in range(40))]
    way = float(np.linalg.norm(path[-1] - path[0]))
    assert np.linalg.norm(np.diff(path, axis=0), axis=-1).max() < 1.5 * way * DT / 0.5 * 1.2
    assert way > 0.1


def test_a_moving_goal_is_followed_where_it_goes() -> None:
    mine = goals()
    places = [(-0.3, 1.3, 0.25 + 0.002 * step) for step in range(60)]
    for place in places:
        mine.reach("right", place)
        posed(mine, 1)
    _, positions = posed(mine, 1)
    np.testing.assert_allclose(positions[RIGHT], places[-1], atol=1e-6)


def test_a_goal_that_jumps_is_gone_after_without_a_jump() -> None:
    mine = goals()
    mine.reach("left", IN_REACH)
    posed(mine)
    mine.reach("left", (0.25, 1.15, 0.3))
    path = [posed(mine, 1)[1][LEFT] for _ in range(60)]
    assert np.linalg.norm(path[0] - np.array(IN_REACH)) < 0.08
    np.testing.assert_allclose(path[-1], (0.25, 1.15, 0.3), atol=1e-3)


def test_a_goal_without_a_fade_is_met_at_once() -> None:
    mine = goals()
    mine.reach("left", IN_REACH, fade=0.0)
    _, positions = posed(mine, 1)
    np.testing.assert_allclose(positions[LEFT], IN_REACH, atol=1e-6)


def test_hands_that_join_are_as_far_apart_as_told() -> None:
    mine = goals()
    mine.join_hands(0.06)
    _, positions = posed(mine)
    assert np.linalg.norm(positions[LEFT] - positions[RIGHT]) == pytest.approx(0.06, abs=1e-3)


@requirement(29, "contact of the hands during applause")
def test_applause_opens_and_closes() -> None:
    mine = goals()
    mine.join_hands(0.1)
    posed(mine)
    gaps: list[float] = []
    for step in range(60):
        mine.join_hands(0.12 + 0.1 * np.sin(2.0 * np.pi * 3.0 * step * DT))
        _, positions = posed(mine, 1)
        gaps.append(float(np.linalg.norm(positions[LEFT] - positions[RIGHT])))
    assert min(gaps) == pytest.approx(0.02, abs=0.01)
    assert max(gaps) == pytest.approx(0.22, abs=0.01)


def test_the_face_looks_at_its_goal() -> None:
    mine = goals()
    place = np.array([2.0, 1.8, 2.0])
    mine.look_at(place)
    rotations, positions = posed(mine)
    face = rotate(rotations[HEAD], np.array([0.0, 0.0, 1.0]))
    to = place - positions[HEAD]
    assert float(face @ to) / np.linalg.norm(to) > np.cos(np.radians(3.0))
    assert mine.unreached == ()


def test_a_neck_does_not_turn_to_what_is_behind_and_says_so() -> None:
    mine = goals()
    mine.look_at((0.3, 1.6, -3.0))
    rotations, _ = posed(mine)
    face = rotate(rotations[HEAD], np.array([0.0, 0.0, 1.0]))
    assert face[2] > 0.1
    (missed,) = mine.unreached
    assert missed.name == "gaze"
    assert missed.missed > 1.0


@requirement(
    8,
    "They can also be adapted to external constraints specified by the user in realtime (e.g., "
    "height of a chair while sitting).",
)
def test_a_seat_takes_the_hips_to_its_height_and_leaves_the_feet() -> None:
    mine = goals()
    ankles = [leg.ankle for leg in ANATOMY.legs]
    hips = [leg.hip for leg in ANATOMY.legs]
    for height in (0.5, 0.45, 0.6):
        mine.sit(height)
        rotations, positions = posed(mine, 120)
        assert positions[hips, 1].mean() == pytest.approx(height, abs=1e-3)
        np.testing.assert_allclose(positions[ankles], POSITIONS[0, ankles], atol=1e-6)
        np.testing.assert_allclose(rotations[ankles], ROTATIONS[0, ankles], atol=1e-9)


def test_what_is_out_of_reach_is_approached_and_named() -> None:
    mine = goals()
    far = POSITIONS[0, BODY.index("RightArm")] + [0.0, 0.0, 2.0]
    mine.reach("right", far)
    _, positions = posed(mine)
    (missed,) = mine.unreached
    assert missed.name == "right hand"
    assert missed.missed == pytest.approx(np.linalg.norm(positions[RIGHT] - far), abs=1e-6)


def test_what_cannot_be_is_refused_in_words() -> None:
    mine = goals()
    with pytest.raises(ArgumentError, match=r"^the goal of the left hand is \(0, nan, 0\); it"):
        mine.reach("left", (0, float("nan"), 0))
    with pytest.raises(ArgumentError, match=r"^a goal with a weight of 2\.0; it must be within 0"):
        mine.look_at((0, 0, 1), weight=2.0)
    with pytest.raises(ArgumentError, match=r"^a goal that fades in -1\.0 s; it must be finite"):
        mine.sit(0.5, fade=-1.0)
    with pytest.raises(ArgumentError, match=r"^hands -0\.1 m apart; it must be finite and >= 0$"):
        mine.join_hands(-0.1)
    with pytest.raises(UnknownNameError, match="gaze"):
        mine.drop("nose")
    legs = body(
        """
        Hips
          LeftUpLeg 0.1 0 0
            LeftLeg 0 -0.4 0
              LeftFoot 0 -0.4 0 tip 0 -0.05 0.1
          RightUpLeg -0.1 0 0
            RightLeg 0 -0.4 0
              RightFoot 0 -0.4 0 tip 0 -0.05 0.1
        """
    )
    bare = goals(legs)
    with pytest.raises(
        ArgumentError, match=r"^a goal for the left hand of a body without that arm"
    ):
        bare.reach("left", (0, 1, 0))
    with pytest.raises(ArgumentError, match=r"^a gaze for a body without a head"):
        bare.look_at((0, 1, 0))


@settings(max_examples=40, deadline=None)
@given(
    st.tuples(*[st.floats(-2.0, 2.0)] * 3),
    st.tuples(*[st.floats(-2.0, 2.0)] * 3),
    st.floats(-1.0, 3.0),
    st.floats(0.0, 1.0),
)
def test_no_goal_gives_a_number_that_is_none(
    hand: tuple[float, float, float],
    gaze: tuple[float, float, float],
    seat: float,
    weight: float,
) -> None:
    mine = goals()
    mine.reach("left", hand, weight=weight, fade=0.0)
    mine.reach("right", POSITIONS[0, BODY.index("RightArm")], fade=0.0)
    mine.look_at(gaze, weight=weight, fade=0.0)
    mine.sit(seat, weight=weight, fade=0.0)
    rotations, positions = posed(mine, 2)
    assert np.isfinite(rotations).all()
    assert np.isfinite(positions).all()
