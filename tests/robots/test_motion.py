from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import biped_clip

from footfall.detection import frame_symbols
from footfall.errors import FileFormatError, SkeletonError
from footfall.robots import (
    clip_of_robot,
    load_robot_motion,
    our_robot,
    perform_on_robot,
    save_robot_motion,
)
from footfall.robots.landmarks import landmark_targets, landmarks
from footfall.samples import sample

pytest.importorskip("mujoco")

ROBOT = our_robot()
MOVES = ("walk", "run", "kick", "jump", "punch", "side-step")


@pytest.mark.parametrize("name", MOVES)
def test_the_landmarks_come_near_their_targets_within_the_hinges_ranges(name: str) -> None:
    clip, supports = sample(name)
    motion = perform_on_robot(ROBOT, clip, supports)
    targets = landmark_targets(ROBOT, clip)
    data = ROBOT.mujoco.MjData(ROBOT.model)
    misses = np.empty(targets.shape[:2])
    for frame, qpos in enumerate(motion.qpos):
        data.qpos[:] = qpos
        ROBOT.mujoco.mj_kinematics(ROBOT.model, data)
        for index, point in enumerate(landmarks(ROBOT)):
            place = data.xpos[point.body] + data.xmat[point.body].reshape(3, 3) @ point.offset
            misses[frame, index] = np.linalg.norm(place - targets[frame, index])
    assert np.median(misses) < 0.012
    assert misses.max() < 0.05
    low, high = ROBOT.model.jnt_range[1:].T
    assert (motion.qpos[:, 7:] >= low - 1e-12).all()
    assert (motion.qpos[:, 7:] <= high + 1e-12).all()


def test_a_standing_foot_stands_flat_on_the_floor_and_slides_little() -> None:
    clip, supports = sample("walk")
    motion = perform_on_robot(ROBOT, clip, supports)
    data = ROBOT.mujoco.MjData(ROBOT.model)
    body = ROBOT.anatomy.left.ankle + 1
    places: list[tuple[float, ...]] = []
    middle = [s.left and not s.right for s in map(supports.support_at, np.arange(65) / 60.0)]
    for qpos in motion.qpos[np.array(middle)][4:-8]:
        data.qpos[:] = qpos
        ROBOT.mujoco.mj_kinematics(ROBOT.model, data)
        places.append((*data.xpos[body], data.xmat[body][8]))
    held = np.array(places)
    assert np.abs(held[:, 2] - ROBOT.sole_height).max() < 0.02
    assert held[:, 3].min() > np.cos(np.radians(15.0))
    assert np.ptp(held[:, :2], axis=0).max() < 0.04


def test_the_labels_are_those_of_the_motion(tmp_path: Path) -> None:
    clip, supports = sample("walk")
    path = tmp_path / "walk.npz"
    save_robot_motion(perform_on_robot(ROBOT, clip, supports), ROBOT, path)
    with np.load(path) as stored:
        assert "".join(stored["supports"]) == frame_symbols(supports, clip.fps, clip.frames)
        assert stored["qpos"].shape == (65, 32)
        assert stored["qvel"].shape == (65, 31)
        np.testing.assert_array_equal(stored["joint_targets"], stored["qpos"][:, 7:])


def test_velocities_lead_from_each_frame_to_the_next() -> None:
    clip, supports = sample("run")
    motion = perform_on_robot(ROBOT, clip, supports)
    for frame in range(clip.frames - 1):
        qpos = motion.qpos[frame].copy()
        ROBOT.mujoco.mj_integratePos(ROBOT.model, qpos, motion.qvel[frame], 1.0 / motion.fps)
        np.testing.assert_allclose(qpos, motion.qpos[frame + 1], atol=1e-9)


def test_what_is_read_back_is_what_the_robot_does(tmp_path: Path) -> None:
    clip, supports = sample("kick")
    path = tmp_path / "kick.npz"
    written = perform_on_robot(ROBOT, clip, supports)
    save_robot_motion(written, ROBOT, path)
    motion = load_robot_motion(path)
    np.testing.assert_array_equal(motion.qpos, written.qpos)
    np.testing.assert_array_equal(motion.supports, written.supports)
    back = clip_of_robot(motion, ROBOT, path)
    assert (back.fps, back.frames, back.name) == (60.0, clip.frames, "kick")
    data = ROBOT.mujoco.MjData(ROBOT.model)
    _, positions = back.world_poses()
    for frame in range(0, clip.frames, 9):
        data.qpos[:] = motion.qpos[frame]
        ROBOT.mujoco.mj_kinematics(ROBOT.model, data)
        for joint, name in enumerate(back.skeleton.names):
            x, y, z = data.xpos[ROBOT.model.body(name).id]
            np.testing.assert_allclose(positions[frame, joint], [y, z, x], atol=1e-9)


def test_another_robot_s_motion_is_refused(tmp_path: Path) -> None:
    clip, supports = sample("run")
    motion = perform_on_robot(ROBOT, clip, supports)
    other = type(motion)(
        motion.qpos, motion.qvel, motion.supports, 60.0, ("a", *motion.joint_names[1:]), "x"
    )
    with pytest.raises(FileFormatError) as caught:
        clip_of_robot(other, ROBOT, tmp_path / "x.npz")
    assert str(caught.value) == (
        f"{tmp_path / 'x.npz'}: moves 25 hinges (a, lumbar_pitch, lumbar_roll, ...), but 'footfall "
        "humanoid' has 25 (lumbar_yaw, lumbar_pitch, lumbar_roll, ...); name its own model"
    )


def test_a_body_without_arms_is_refused() -> None:
    _, supports = sample("run")
    with pytest.raises(SkeletonError, match="no two arms are found"):
        perform_on_robot(ROBOT, biped_clip(), supports)


@pytest.mark.parametrize("data", [b"", b"PK\x03\x04", b"no such thing"])
def test_what_is_no_robot_s_motion_is_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "x.npz"
    path.write_bytes(data)
    with pytest.raises(FileFormatError, match="is damaged or no motion of a robot: "):
        load_robot_motion(path)


def test_a_file_that_unfolds_without_end_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.npz"
    np.savez_compressed(path, header=np.zeros(60_000_000, dtype=np.uint8))
    with pytest.raises(FileFormatError, match=r"it unfolds from \d+ to 60000128 bytes"):
        load_robot_motion(path)
