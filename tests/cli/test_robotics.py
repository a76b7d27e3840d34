from __future__ import annotations

from pathlib import Path

import pytest

from footfall.cli import main
from footfall.io import load

pytest.importorskip("mujoco")

Captured = pytest.CaptureFixture[str]


def test_a_motion_goes_to_a_robot_and_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["robot-model", "-o", "humanoid.xml", "--stature", "1.6"]) == 0
    assert main(["robot", "sample:walk", "--model", "humanoid.xml", "-o", "walk.npz"]) == 0
    assert main(["robot", "walk.npz", "--model", "humanoid.xml", "--back", "-o", "back.bvh"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "humanoid.xml",
        "walk.npz: 65 frames of 'footfall humanoid', 25 hinges, supports as they came with the "
        "motion",
        "back.bvh: 65 frames, 1.067 s, 15 joints",
    ]
    assert load("back.bvh").skeleton.names[0] == "pelvis"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (
            "robot sample:walk -o walk.bvh",
            "walk.bvh: cannot be written: a robot's motion is a .npz file",
        ),
        ("robot none.npz --back -o x.bvh", "none.npz: there is no such file; check the name"),
        (
            "robot sample:walk --model none.xml -o x.npz",
            "none.xml: there is no such file; check the name",
        ),
        ("robot-model -o x.xml --stature 9", "stature is 9.0 m; it must be within 0.5 to 2.5 m"),
    ],
)
def test_wrong_input_is_told_in_one_line_and_nothing_is_written(
    words: str, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(words.split()) == 2
    assert capsys.readouterr().err == f"footfall: {told}\n"
    assert list(tmp_path.iterdir()) == []
