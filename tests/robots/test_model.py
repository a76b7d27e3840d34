from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from footfall.errors import FileFormatError, MissingExtraError
from footfall.robots import humanoid_mjcf, load_robot, our_robot
from footfall.robots.model import to_mujoco, to_ours

pytest.importorskip("mujoco")


def test_a_model_from_a_file_is_the_model(tmp_path: Path) -> None:
    path = tmp_path / "humanoid.xml"
    path.write_text(humanoid_mjcf())
    robot, ours = load_robot(path), our_robot()
    assert (robot.name, robot.hinges, robot.digest) == (ours.name, ours.hinges, ours.digest)
    assert robot.skeleton.names == ours.skeleton.names


def test_its_bodies_are_a_body_with_legs_arms_and_a_head() -> None:
    robot = our_robot()
    names = robot.skeleton.names
    assert [names[leg.ankle] for leg in robot.anatomy.legs] == ["left_foot", "right_foot"]
    assert all(arm is not None for arm in robot.anatomy.arms)
    assert robot.sole_height == pytest.approx(0.039 * 1.75, abs=1e-4)


def test_axes_go_there_and_back() -> None:
    np.testing.assert_array_equal(to_ours(np.array([1.0, 2.0, 3.0])), [2.0, 3.0, 1.0])
    np.testing.assert_array_equal(to_mujoco(to_ours(np.array([1.0, 2.0, 3.0]))), [1.0, 2.0, 3.0])


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("no such thing", "is no MJCF model: "),
        ("<mujoco/>", "has joints of the kinds []; a humanoid has a free root (0) first"),
        (
            '<mujoco><worldbody><body><freejoint/><geom size="1"/><body><joint type="ball"/>'
            '<geom size="1"/></body></body></worldbody></mujoco>',
            "has joints of the kinds [0, 1]; a humanoid has a free root (0) first",
        ),
        (
            '<mujoco><worldbody><body name="cart"><freejoint/><geom size="1"/></body></worldbody>'
            "</mujoco>",
            "is no humanoid: ",
        ),
        (
            '<mujoco><worldbody><body name="a"><freejoint/><geom size="1"/></body><body name="b">'
            '<geom size="1"/></body></worldbody></mujoco>',
            "is no humanoid: ",
        ),
    ],
)
def test_what_is_no_humanoid_is_refused_in_one_line(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    with pytest.raises(FileFormatError) as caught:
        load_robot(path)
    assert str(caught.value).startswith(f"{path}: {told}")
    assert "\n" not in str(caught.value)


def test_without_the_library_the_way_to_get_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(MissingExtraError) as caught:
        our_robot()
    assert str(caught.value) == (
        "reading footfall-humanoid.xml needs mujoco; pip install 'footfall[robot]'"
    )


def test_no_log_is_left_in_the_folder_one_is_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    path = tmp_path / "robot.xml"
    path.write_text(humanoid_mjcf().replace('range="-45', 'range="nan', 1))
    with pytest.raises(FileFormatError):
        load_robot(path)
    assert list((tmp_path / "here").iterdir()) == []
