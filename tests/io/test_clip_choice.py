from __future__ import annotations

from pathlib import Path

import pytest

from footfall.io.clip_choice import split_choice


@pytest.mark.parametrize(
    ("text", "file", "choice"),
    [
        ("walk.glb", "walk.glb", None),
        ("walk.glb#Walk_Loop", "walk.glb", "Walk_Loop"),
        ("a/b.gltf#2", "a/b.gltf", "2"),
        ("take.FBX#Take 001", "take.FBX", "Take 001"),
        ("take.fbx.gz#run#fast", "take.fbx.gz", "run#fast"),
        ("odd#name.glb", "odd#name.glb", None),
        ("walk.bvh#1", "walk.bvh#1", None),
        ("walk.glb#", "walk.glb#", None),
    ],
)
def test_what_stands_behind_the_sign_names_a_clip(text: str, file: str, choice: str | None) -> None:
    assert split_choice(text) == (Path(file), choice)


def test_a_file_of_that_very_name_is_that_file(tmp_path: Path) -> None:
    path = tmp_path / "walk.glb#1"
    assert split_choice(path) == (tmp_path / "walk.glb", "1")
    path.touch()
    assert split_choice(path) == (path, None)


def test_a_name_that_no_file_can_have_is_left_to_the_reader() -> None:
    text = "x" * 5000 + ".glb#1"
    assert split_choice(text) == (Path(text), None)
