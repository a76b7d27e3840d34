from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import biped_clip
from tests.io.small_usd import usd_text, usd_world

from footfall.errors import ArgumentError, FileFormatError, MissingExtraError
from footfall.io import load, load_with_conclusions

pytest.importorskip("pxr")

CLIP = biped_clip()


def written(tmp_path: Path, **options: object) -> Path:
    path = tmp_path / "walk.usda"
    path.write_bytes(usd_text(CLIP, **options))  # type: ignore[arg-type]
    return path


@pytest.mark.parametrize("up", ["Y", "Z"])
@pytest.mark.parametrize(("metres", "unit"), [(1.0, "m"), (0.01, "cm"), (0.0254, "inch")])
def test_every_joint_is_where_a_slow_reader_finds_it(
    tmp_path: Path, up: str, metres: float, unit: str
) -> None:
    """Within 0.1 mm; single precision leaves 0.0005 mm."""
    clip, conclusions = load_with_conclusions(written(tmp_path, up=up, metres=metres))
    assert clip.skeleton.names == CLIP.skeleton.names
    assert (clip.fps, clip.frames, clip.name) == (30.0, CLIP.frames, "walk")
    strays = np.linalg.norm(clip.world_poses()[1] - usd_world(CLIP, metres, up), axis=-1)
    assert strays.max() < 1e-5
    assert conclusions.up.reason == f"{up.lower()}, as the file says"
    assert conclusions.unit.reason == f"{unit} ({metres:.6g} m), as the file says"


@pytest.mark.parametrize("step", [1.0, 0.5, 160.0])
def test_frames_may_lie_at_any_time_codes(tmp_path: Path, step: float) -> None:
    clip = load(written(tmp_path, step=step))
    assert (clip.frames, clip.fps) == (CLIP.frames, 30.0)


def test_joints_have_their_own_names_where_the_file_gives_them(tmp_path: Path) -> None:
    path = written(tmp_path, names=True)
    assert b"j0/j2" in path.read_bytes()
    assert load(path).skeleton.names == CLIP.skeleton.names


def test_a_wrong_unit_can_be_put_right(tmp_path: Path) -> None:
    clip, conclusions = load_with_conclusions(written(tmp_path, metres=1.0), unit="cm")
    wanted = 0.01 * usd_world(CLIP, 1.0, "Y")
    np.testing.assert_allclose(clip.world_poses()[1], wanted, atol=1e-6)
    assert conclusions.unit.reason == "cm, as asked for; the file says m"


def test_what_the_file_knows_cannot_be_told(tmp_path: Path) -> None:
    with pytest.raises(ArgumentError, match="knows its upward axis and rate"):
        load(written(tmp_path), up="z")


EMPTY = b"#usda 1.0\n"


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"", "is damaged or no USD file: "),
        (b"no such thing", "is damaged or no USD file: "),
        (usd_text(CLIP)[:-200], "is damaged or no USD file: "),
        (EMPTY, "holds no skeleton: no Skeleton prim with joints is in it"),
        (
            usd_text(CLIP).replace(b"timeCodesPerSecond = 30.0", b"timeCodesPerSecond = -1"),
            "has -1 time codes per second; more than 0 and at most 10000 are possible",
        ),
        (
            usd_text(CLIP).replace(b"7.0: [", b"7000000000.0: ["),
            "its animation runs from 0 to 7e+09 in steps of 1, far more than such a file holds",
        ),
        (
            usd_text(CLIP).replace(b"metersPerUnit = 0.01", b"metersPerUnit = 0"),
            "says of itself: a unit of 0.0 m is impossible; it must be longer than zero",
        ),
    ],
)
def test_a_damaged_file_is_refused_in_one_line(tmp_path: Path, data: bytes, told: str) -> None:
    path = tmp_path / "walk.usda"
    path.write_bytes(data)
    with pytest.raises(FileFormatError) as caught:
        load(path)
    assert str(caught.value).startswith(f"{path}: {told}")
    assert "\n" not in str(caught.value)


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        load(tmp_path / "none.usd")
    assert str(caught.value) == f"{tmp_path / 'none.usd'}: there is no such file; check the name"


def test_without_the_library_the_way_to_get_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(MissingExtraError) as caught:
        load(written(tmp_path))
    assert str(caught.value) == "reading walk.usda needs usd-core; pip install 'footfall[usd]'"
