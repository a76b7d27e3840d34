"""Where the joints of real files are, against readers that share no code with ours."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

import gzip
import json
import subprocess
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from tests.oracles.slow_gltf import SlowGltf

from footfall.errors import FootfallError
from footfall.geometry import multiply, rotate
from footfall.io import (
    gltf_animations,
    load,
    load_skinned,
    load_with_conclusions,
    save_bvh,
    save_gltf,
    save_skinned,
)
from footfall.io.bvh_rig import BvhRig, parse_bvh
from footfall.io.gltf_clip import gltf_body
from footfall.io.gltf_document import read_document
from footfall.io.gltf_rig import rig_at
from footfall.motion import Clip

FOLDER = Path(__file__).parents[3] / "shared" / "motions"
NODE = Path(__file__).parents[1] / "node"

needs_clips = pytest.mark.skipif(not FOLDER.exists(), reason="no ../shared/motions")
needs_node = pytest.mark.skipif(
    not (NODE / "node_modules").exists(), reason="run `npm install` in tests/node first"
)

TENTH = 1e-4
"""A tenth of a millimeter [m]."""


def animations() -> list[tuple[str, str]]:
    paths = sorted(FOLDER.glob("gltf/*.glb"))
    return [(path.name, name) for path in paths for name in gltf_animations(path)]


def free_positions(rig: BvhRig) -> npt.NDArray[np.float64]:
    """Return where the joints are if each may move in its parent, shape (frames, joints, 3)."""
    rotations = np.array(rig.rotations)
    positions = np.empty((*rotations.shape[:2], 3))
    for joint, parent in enumerate(rig.parents.tolist()):
        place = rig.translations.get(joint, np.tile(rig.offsets[joint], (rig.frames, 1)))
        if parent < 0:
            positions[:, joint] = place
            continue
        positions[:, joint] = positions[:, parent] + rotate(rotations[:, parent], place)
        rotations[:, joint] = multiply(rotations[:, parent], rotations[:, joint])
    return positions


@needs_clips
@pytest.mark.parametrize(("name", "animation"), animations())
def test_every_joint_of_a_glb_is_where_the_oracle_has_it(name: str, animation: str) -> None:
    path = FOLDER / "gltf" / name
    body = gltf_body(read_document(path))
    number = body.animations.index(animation)
    channels = body.channels(number)
    slow = SlowGltf(path)
    times = np.linspace(0.0, max(float(one.times[-1]) for one in channels), 5)
    places = free_positions(rig_at(body.document, body.nodes, body.joints, channels, times, 30.0))
    for frame, time in enumerate(times.tolist()):
        moved = slow.properties(number, time)
        wanted = np.array([slow.world(node, moved)[:3, 3] for node in body.joints.nodes])
        assert np.linalg.norm(places[frame] - wanted, axis=-1).max() < TENTH
    try:
        clip, conclusions = load_with_conclusions(path, animation=animation)
    except FootfallError as error:
        # These are animated by moving joints of the legs in their parents.
        assert "bake the motion to rotations first" in str(error)  # noqa: PT017
        return
    if "position channels" in conclusions.bones.reason and conclusions.bones.value > 1e-5:
        return
    first = min(float(one.times[0]) for one in channels)
    moved = slow.properties(number, first)
    names = dict(zip(body.joints.names, body.joints.nodes, strict=True))
    wanted = np.array([slow.world(names[one], moved)[:3, 3] for one in clip.skeleton.names])
    assert np.linalg.norm(clip.world_poses()[1][0] - wanted, axis=-1).max() < TENTH


def matrix(w: float, x: float, y: float, z: float) -> npt.NDArray[np.float64]:
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def slow_deepmimic(frame: list[float], joints: list[Any]) -> npt.NDArray[np.float64]:
    """Return where the joints of a frame are, with matrices, one number after the other."""
    values = iter(frame[1:])
    turned: list[npt.NDArray[np.float64]] = []
    placed: list[npt.NDArray[np.float64]] = []
    for index, joint in enumerate(joints):
        attach = np.array([joint[f"Attach{axis}"] for axis in "XYZ"])
        if index == 0:
            attach = np.array([next(values) for _ in range(3)])
        turn = np.eye(3)
        if index == 0 or joint["Type"] == "spherical":
            # Some of these files hold quaternions of length 0.6 to 1.2.
            given = np.array([next(values) for _ in range(4)])
            turn = matrix(*(given / np.linalg.norm(given)))
        elif joint["Type"] == "revolute":
            angle = next(values)
            turn = matrix(np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2))
        parent = joint["Parent"]
        placed.append(attach if index == 0 else placed[parent] + turned[parent] @ attach)
        turned.append(turn if index == 0 else turned[parent] @ turn)
    return np.array(placed)


@needs_clips
@pytest.mark.parametrize(
    "name", sorted(p.name for p in FOLDER.glob("deepmimic/*.gz") if "character" not in p.name)
)
def test_every_joint_of_a_deepmimic_motion_is_where_the_oracle_has_it(name: str) -> None:
    path = FOLDER / "deepmimic" / name
    body = FOLDER / "deepmimic" / "humanoid3d_character.txt.gz"
    joints = json.loads(gzip.decompress(body.read_bytes()))["Skeleton"]["Joints"]
    frames = json.loads(gzip.decompress(path.read_bytes()))["Frames"]
    # Where a frame lasts longer than the others, frames are put between.
    clip = load(path, fps=60.0)
    for character in (None, body):
        assert np.array_equal(
            load(path, fps=60.0, body=character).world_poses()[1], clip.world_poses()[1]
        )
    assert clip.frames == len(frames)
    order = [[one["Name"] for one in joints].index(name) for name in clip.skeleton.names]
    wanted = np.array([slow_deepmimic(frame, joints)[order] for frame in frames])
    assert np.linalg.norm(clip.world_poses()[1] - wanted, axis=-1).max() < TENTH


WRITTEN = (
    "ozz/pab_run.bvh.gz",
    "snu_ys2010/woody_kick.bvh.gz",
    "pybvh/rig_mixed_orders_zup.bvh.gz",
    "deepmimic/humanoid3d_cartwheel.txt.gz",
    "gltf/viverse_walk.glb",
)


def by_pybvh(path: Path, clip: Clip) -> npt.NDArray[np.float64]:
    pybvh = pytest.importorskip("pybvh", reason="pip install -e '.[dev-readers]'")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        read = pybvh.read_bvh_file(str(path))
        places = read.joint_positions()
    return np.stack([places[:, read.joint_names.index(one)] for one in clip.skeleton.names], axis=1)


def by_bvhio(path: Path, clip: Clip) -> npt.NDArray[np.float64]:
    bvhio = pytest.importorskip("bvhio", reason="pip install -e '.[dev-readers]'")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        root = bvhio.readAsHierarchy(str(path))
        frames = []
        for frame in range(clip.frames):
            root.loadPose(frame)
            placed = {joint.Name: tuple(joint.PositionWorld) for joint, _, _ in root.layout()}
            frames.append([placed[one] for one in clip.skeleton.names])
    return np.array(frames)


@needs_clips
@pytest.mark.parametrize("reader", [by_pybvh, by_bvhio])
@pytest.mark.parametrize("name", WRITTEN)
def test_other_readers_find_the_joints_of_a_written_bvh_where_ours_has_them(
    tmp_path: Path, name: str, reader: Any
) -> None:
    clip = load(FOLDER / name)
    save_bvh(clip, tmp_path / "a.bvh")
    read = reader(tmp_path / "a.bvh", clip)
    stray = np.linalg.norm(read - clip.world_poses()[1], axis=-1).max()
    print(f"{name} by {reader.__name__[3:]}: {stray * 1000.0:.4f} mm")
    assert stray < TENTH


READ = tuple(
    f"{path.parent.name}/{path.name}"
    for folder in ("mass", "pymo")
    for path in sorted(FOLDER.glob(f"{folder}/*.bvh.gz"))
)


@pytest.mark.full
@needs_clips
@pytest.mark.parametrize("name", READ)
def test_every_joint_of_a_bvh_is_where_another_reader_has_it(tmp_path: Path, name: str) -> None:
    plain = tmp_path / "a.bvh"
    plain.write_bytes(gzip.decompress((FOLDER / name).read_bytes()))
    clip, conclusions = load_with_conclusions(plain)
    assert (conclusions.up.value, conclusions.bones.value) == ("y", 0.0)
    read = conclusions.unit.value.metres * by_pybvh(plain, clip)
    stray = np.linalg.norm(read - clip.world_poses()[1], axis=-1).max()
    print(f"{name} by pybvh: {stray * 1000.0:.4f} mm")
    assert stray < TENTH


@pytest.mark.full
@needs_clips
@pytest.mark.parametrize("name", sorted(path.name for path in FOLDER.glob("ozz/*.bvh.gz")))
def test_joints_that_move_in_their_parents_are_where_another_reader_has_them(
    tmp_path: Path, name: str
) -> None:
    plain = tmp_path / "a.bvh"
    plain.write_bytes(gzip.decompress((FOLDER / "ozz" / name).read_bytes()))
    clip, conclusions = load_with_conclusions(plain)
    metres = conclusions.unit.value.metres
    read = metres * by_bvhio(plain, clip)
    rig = parse_bvh(plain.read_bytes(), plain)
    columns = [rig.names.index(joint) for joint in clip.skeleton.names]
    free = metres * free_positions(rig)[:, columns]
    strays = [np.linalg.norm(read - ours, axis=-1).max() for ours in (free, clip.world_poses()[1])]
    print(f"{name} by bvhio: {strays[0] * 1000.0:.4f} mm, bones fixed {strays[1] * 1000.0:.1f} mm")
    assert strays[0] < TENTH
    # What fixed bones lose is what is told.
    assert strays[1] < conclusions.bones.value + TENTH


@needs_clips
@needs_node
def test_the_khronos_validator_has_nothing_to_say(tmp_path: Path) -> None:
    walk = load(FOLDER / "gltf" / "viverse_walk.glb")
    run = load(FOLDER / "gltf" / "viverse_run.glb")
    there = walk.pelvis_positions + np.linspace(0.0, 1.5, walk.frames)[:, np.newaxis] * [0, 0, 1]
    save_gltf(walk, tmp_path / "mannequin.glb")
    body = load_skinned(FOLDER / "gltf" / "viverse_mannequin.glb")
    save_skinned(
        body, [walk.evolve(pelvis_positions=there, cyclic=False), run], tmp_path / "skin.glb"
    )
    pose = load(FOLDER / "gltf" / "m2m_human-male.glb")
    still = pose.evolve(
        pelvis_positions=np.repeat(pose.pelvis_positions, 2, axis=0),
        local_rotations=np.repeat(pose.local_rotations, 2, axis=0),
    )
    save_skinned(
        load_skinned(FOLDER / "gltf" / "m2m_human-male.glb"), [still], tmp_path / "human.glb"
    )
    robot = FOLDER / "gltf" / "RobotExpressive.glb"
    dances = [load(robot, animation=one) for one in ("Dance", "Wave")]
    save_skinned(load_skinned(robot), dances, tmp_path / "robot.glb")
    paths = sorted(map(str, tmp_path.glob("*.glb")))
    done = subprocess.run(
        ["node", "validate.cjs", *paths], cwd=NODE, capture_output=True, text=True, check=True
    )
    told = json.loads(done.stdout)
    assert [(one["errors"], one["warnings"]) for one in told] == [(0, 0)] * 4, told
