"""A motion on another body."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.skeleton.bodies import body
from tests.walking_figure import skeleton, walk

from footfall.errors import SkeletonError
from footfall.geometry import conjugate, multiply
from footfall.motion import Clip
from footfall.motion.retargeting import map_clip, retarget
from footfall.motion.soles import with_soles
from footfall.skeleton import Skeleton, find_anatomy
from footfall.skeleton.rig import rig_of

ROBOT = """
Base
  Torso 0 0.15 0
    Skull 0 0.45 0
    shoulder_l 0.2 0.35 0
      elbow_l 0.25 0 0
        wrist_l 0.22 0 0
    shoulder_r -0.2 0.35 0
      elbow_r -0.25 0 0
        wrist_r -0.22 0 0
  hip_l 0.1 0 0
    knee_l 0 -0.35 0
      ankle_l 0 -0.35 0 tip 0 -0.08 0.15
  hip_r -0.1 0 0
    knee_r 0 -0.35 0
      ankle_r 0 -0.35 0 tip 0 -0.08 0.15
"""


def scaled(factor: float) -> Skeleton:
    own = skeleton()
    return Skeleton(own.names, own.parents, factor * own.rest_offsets, factor * own.tip_offsets)


def renamed(own: Skeleton) -> Skeleton:
    """Return the same body as another family: one joint has another name."""
    names = tuple("Bauch" if name == "Spine" else name for name in own.names)
    return Skeleton(names, own.parents, own.rest_offsets, own.tip_offsets)


def test_the_same_body_gives_the_motion_back() -> None:
    clip = walk()
    again = retarget(clip, clip.skeleton)
    assert np.abs(again.world_poses()[1] - clip.world_poses()[1]).max() < 1e-3
    angles = multiply(conjugate(again.local_rotations), clip.local_rotations)[..., 0]
    assert np.degrees(2.0 * np.arccos(np.minimum(np.abs(angles), 1.0))).max() < 0.5


def test_the_same_body_under_another_name_gives_the_motion_back() -> None:
    clip = walk()
    again = retarget(clip, renamed(clip.skeleton))
    assert np.abs(again.world_poses()[1] - clip.world_poses()[1]).max() < 1e-3


@pytest.mark.parametrize("factor", [0.6, 1.6])
def test_a_scaled_body_does_the_scaled_motion(factor: float) -> None:
    clip = walk()
    result = retarget(clip, renamed(scaled(factor)))
    expected = factor * clip.world_poses()[1]
    assert np.abs(result.world_poses()[1] - expected).max() < 1e-3 * factor


def test_there_and_back_is_the_motion_again() -> None:
    clip = walk()
    there = retarget(clip, renamed(scaled(1.6)))
    back = retarget(there, clip.skeleton)
    assert np.abs(back.world_poses()[1] - clip.world_poses()[1]).max() < 1e-3


def test_a_robot_without_toes_stands_on_its_soles() -> None:
    clip = walk()
    robot = body(ROBOT)
    result = retarget(clip, robot)
    rotations, positions = result.world_poses()
    rig = rig_of(robot, with_soles(find_anatomy(robot), rotations, positions))
    assert np.isfinite(positions).all()
    assert positions[:, robot.index("ankle_l"), 1].min() > 0.0
    assert (rig.foot_points[:, 1, 2] > 0.1).all()


def test_a_cycle_stays_a_cycle() -> None:
    one = walk()
    local = np.array(one.local_rotations)
    local[-1] = local[0]
    clip = Clip(one.skeleton, one.pelvis_positions, local, one.fps, cyclic=True)
    result = retarget(clip, renamed(scaled(0.7)))
    assert result.cyclic
    assert np.array_equal(result.local_rotations[-1, 1:], result.local_rotations[0, 1:])


def test_the_provenance_says_what_was_done() -> None:
    result = retarget(walk(), renamed(scaled(0.5)))
    assert result.provenance[-1] == "retargeted from 21 to 21 joints, legs 0.500 times as long"


def test_a_body_without_legs_is_refused_with_the_reason() -> None:
    with pytest.raises(SkeletonError, match=r"^no map between the two bodies: the followed one"):
        map_clip(walk(), body("Base\n  Arm 0 1 0\n    Hand 0 1 0"))


def test_a_map_of_other_bodies_is_refused() -> None:
    clip = walk()
    other = map_clip(clip, body(ROBOT))
    message = "the map is of other bodies than those of the motion and its performer"
    with pytest.raises(SkeletonError, match=f"^{re.escape(message)}$"):
        retarget(clip, clip.skeleton, other)


@settings(max_examples=25, deadline=None)
@given(
    scales=st.lists(st.floats(0.0, 3.0), min_size=21, max_size=21),
    turns=st.integers(0, 2**31),
)
def test_no_body_gives_a_number_that_is_none(scales: list[float], turns: int) -> None:
    own = skeleton()
    offsets = own.rest_offsets * np.array(scales)[:, np.newaxis]
    noise = np.random.default_rng(turns).normal(size=(5, own.count, 4))
    local = noise / np.linalg.norm(noise, axis=-1, keepdims=True)
    clip = Clip(own, np.zeros((5, 3)), local, 30.0)
    other = renamed(Skeleton(own.names, own.parents, offsets, own.tip_offsets))
    try:
        result = retarget(clip, other)
    except SkeletonError:
        return
    assert np.isfinite(result.world_poses()[1]).all()
