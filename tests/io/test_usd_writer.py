from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests import walking_figure
from tests.io.small_biped import biped_clip

from footfall.errors import FileFormatError
from footfall.io import load, save
from footfall.io.clip_mannequin import clip_mannequin
from footfall.motion import Clip
from footfall.skeleton import Skeleton

pxr_usd: Any = pytest.importorskip("pxr.Usd")

SUFFIXES = (".usda", ".usdc", ".usd")


def arm() -> Clip:
    """Return a body whose joints have names that USD does not allow."""
    offsets = np.array([[0.0, 0.0, 0.0], [0.0, 0.2, 0.0], [0.1, 0.0, 0.0], [0.0, 0.2, 0.1]])
    body = Skeleton(("1 base", "größe", "a:b", "größe_"), np.array([-1, 0, 1, 0]), offsets)
    turned = np.tile([1.0, 0.0, 0.0, 0.0], (3, 4, 1))
    return Clip(body, np.zeros((3, 3)), turned, 25.0, name="arm")


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("clip", [walking_figure.walk(), biped_clip()], ids=lambda c: c.name)
def test_what_is_written_is_read_again(tmp_path: Path, clip: Clip, suffix: str) -> None:
    path = tmp_path / f"{clip.name}{suffix}"
    save(clip, path)
    read = load(path)
    assert read.skeleton.names == clip.skeleton.names
    assert (read.fps, read.frames, read.name) == (clip.fps, clip.frames, clip.name)
    np.testing.assert_allclose(read.world_poses()[1], clip.world_poses()[1], atol=1e-6)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("clip", [walking_figure.walk(), arm()], ids=lambda c: c.name)
def test_every_check_of_usdchecker_passes(tmp_path: Path, clip: Clip, suffix: str) -> None:
    validation: Any = pytest.importorskip("pxr.UsdValidation")
    path = tmp_path / f"clip{suffix}"
    save(clip, path)
    validators = validation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 20
    found = validation.ValidationContext(validators).Validate(pxr_usd.Stage.Open(str(path)))
    assert [(error.GetName(), error.GetMessage()) for error in found] == []


def test_names_that_the_format_does_not_allow_are_kept_beside(tmp_path: Path) -> None:
    path = tmp_path / "arm.usda"
    save(arm(), path)
    assert load(path).skeleton.names == arm().skeleton.names
    text = path.read_text(encoding="utf-8")
    assert 'jointNames = ["1 base", "größe", "a:b", "größe_"]' in text
    joints = '["_1_base", "_1_base/gr__e", "_1_base/gr__e/a_b", "_1_base/gr__e_"]'
    assert f"uniform token[] joints = {joints}" in text


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_same_clip_gives_the_same_bytes(tmp_path: Path, suffix: str) -> None:
    for name in ("one", "other"):
        save(walking_figure.walk(), tmp_path / f"{name}{suffix}")
    one, other = (tmp_path / f"{name}{suffix}" for name in ("one", "other"))
    assert one.read_bytes() == other.read_bytes()


def test_the_mannequin_is_posed_by_the_animation(tmp_path: Path) -> None:
    skel: Any = pytest.importorskip("pxr.UsdSkel")
    path = tmp_path / "walk.usdc"
    clip = walking_figure.walk()
    save(clip, path)
    stage = pxr_usd.Stage.Open(str(path))
    gf: Any = pytest.importorskip("pxr.Gf")
    root = skel.Root(stage.GetPrimAtPath("/Body"))
    assert skel.BakeSkinning(root, gf.Interval(30, 30))
    points = np.array(stage.GetPrimAtPath("/Body/Mannequin").GetAttribute("points").Get(30))
    joints = clip.world_poses()[1][30]
    assert np.ptp(points[:, 1]) > 1.4
    away = np.linalg.norm(points[:, np.newaxis] - joints, axis=-1).min(axis=1)
    assert away.max() < 0.35
    rotations, positions = clip.world_poses()
    placed = clip_mannequin(clip).placed(rotations[30], positions[30])
    np.testing.assert_allclose(points, placed, atol=1e-4)


def test_nothing_is_written_into_a_missing_folder(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError, match="there is no folder"):
        save(walking_figure.walk(), tmp_path / "missing" / "walk.usd")
    assert list(tmp_path.iterdir()) == []
