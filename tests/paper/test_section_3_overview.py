"""Section 3 and figure 1: what the engine around the synchronization does, in which order."""

from __future__ import annotations

import ast
import inspect

import numpy as np
import pytest
from tests.engine.test_pipeline import CUES, drift, play, walker
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Positions
from footfall.engine import pipeline
from footfall.geometry import conjugate, from_yaw, rotate
from footfall.motion import extract_root_path
from footfall.skeleton import find_anatomy
from footfall.skeleton.normalized import channel_count, normalize
from footfall.skeleton.rig import rig_of


@requirement(
    23,
    "part of a complete real-time kinematic animation engine called MKM (Manageable Kinematics "
    "Motions)",
)
def test_figure_1_actions_are_synchronized_then_blended_then_adapted() -> None:
    functions = {
        node.name: node
        for node in ast.walk(ast.parse(inspect.getsource(pipeline)))
        if isinstance(node, ast.FunctionDef)
    }

    def called(function: str) -> list[str]:
        calls = [
            (node.lineno, node.func.id)
            for node in ast.walk(functions[function])
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        ]
        return [name for _, name in sorted(calls)]

    row = ["pass_time", "blend_poses", "locate_feet", "keep_footprints", "aim_body"]
    assert [name for name in called("_advance_row") if name in row] == row
    block = ["_advance_row", "place_bodies"]
    assert [name for name in called("advance_blocks") if name in block] == block


@requirement(25, "The normalized skeleton is described in cartesian space")
def test_feet_are_positions_in_the_frame_of_the_root() -> None:
    walk, _ = ff.sample("walk")
    anatomy = find_anatomy(walk.skeleton)
    path = extract_root_path(walk, anatomy)
    rig = rig_of(walk.skeleton, anatomy)
    poses = normalize(
        walk.skeleton, rig, walk.pelvis_positions, walk.local_rotations, path.headings, 0.0
    )
    _, world = walk.world_poses()
    roots = np.array(walk.pelvis_positions)
    roots[:, 1] = 0.0
    for side, leg in enumerate(anatomy.legs):
        from_root = rotate(conjugate(from_yaw(path.headings)), world[:, leg.ankle] - roots)
        stored = poses[:, -6 + 3 * side : poses.shape[1] - 3 + 3 * side] * rig.leg_length
        np.testing.assert_allclose(stored, from_root, rtol=0, atol=1e-5)


@requirement(26, "this representation limits the number of parameters to compute at each time")
def test_the_numbers_of_a_pose_are_a_quaternion_a_joint_and_fifteen_more() -> None:
    # A limitation, see docs/paper.md: angles would be three a joint.
    for joints in (1, 17, 24, 80):
        assert channel_count(joints) == 4 * joints + 15


@requirement(27, "It uses morphological and environmental adaptations.")
@requirement(28, "computed after the blending to ensure they are respected")
def test_what_the_ground_asks_for_is_done_after_the_blend_and_so_holds() -> None:
    with_prints = play(walker(), CUES, 260)
    without = play(walker(footprints=False), CUES, 260)
    # The same motions at the same times, the same weights: only what comes after differs.
    assert np.array_equal(with_prints.clip_times, without.clip_times, equal_nan=True)
    assert np.array_equal(with_prints.shares, without.shares)
    assert with_prints.foot_offsets.max() > 0.0
    assert drift(with_prints) < 5.0
    assert drift(with_prints) < drift(without)


@requirement(10, "based on the blending module described in [MMKA04]")
@requirement(
    30, "the blending module blends motions (hence postures at a given time) issued from actions"
)
def test_two_copies_of_a_motion_blend_into_that_motion() -> None:
    def shown(*names: str) -> Positions:
        hero = ff.Character(ff.sample("walk")[0].skeleton, footprints=False)
        for name in names:
            hero.add(name, *ff.sample("walk"))
        cues = {frame: ("start", name) for frame, name in enumerate(names)}
        return play(hero, cues, 200).world_positions

    alone, doubled = shown("one"), shown("one", "two")
    np.testing.assert_allclose(doubled, alone, rtol=0, atol=0.01)


@requirement(31, "can simply replay a motion or can adapt it to parameters as parametric models do")
@pytest.mark.parametrize("name", ["walk", "run", "side-step"])
def test_an_action_alone_replays_its_motion(name: str) -> None:
    hero = ff.Character(ff.sample(name)[0].skeleton, footprints=False)
    hero.add(name, *ff.sample(name))
    recording = play(hero, {0: ("start", name)}, 120)
    times = recording.clip_times[:, 0]
    np.testing.assert_allclose(np.diff(times), 1 / 60, rtol=0, atol=1e-9)
    np.testing.assert_allclose(recording.rates[:, 0], 1.0, rtol=0, atol=1e-9)
