from __future__ import annotations

import gzip
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.io.small_biped import BIPED, biped_clip, biped_text

from footfall.arrays import Floats
from footfall.errors import ArgumentError, FileFormatError
from footfall.geometry import from_euler
from footfall.io import load_bvh, save_bvh
from footfall.io.bvh import read_bvh
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import parse_bvh
from footfall.io.bvh_text import bvh_text
from footfall.io.units import UNITS, Unit, parse_unit
from footfall.motion import Clip
from footfall.skeleton import Skeleton

FILE = Path("walk.bvh")


def reread(clip: Clip, unit: Unit, up: str | None = None) -> Clip:
    rig = parse_bvh(bvh_text(clip, unit, FILE).encode(), FILE)
    return clip_from_rig(rig, FILE, unit=unit.name, up=up)[0]


def angles_between(one: Clip, other: Clip) -> Floats:
    """Return the angle of the rotation from each joint of one clip to the other's [rad]."""
    near = np.where(
        (one.local_rotations * other.local_rotations).sum(axis=-1, keepdims=True) < 0.0, -1.0, 1.0
    )
    return 2.0 * np.linalg.norm(one.local_rotations - near * other.local_rotations, axis=-1)


def assert_same(one: Clip, other: Clip) -> None:
    assert one.skeleton.same_family(other.skeleton)
    np.testing.assert_allclose(one.skeleton.rest_offsets, other.skeleton.rest_offsets, atol=1e-6)
    np.testing.assert_allclose(one.skeleton.tip_offsets, other.skeleton.tip_offsets, atol=1e-6)
    np.testing.assert_allclose(one.pelvis_positions, other.pelvis_positions, atol=1e-6)
    assert angles_between(one, other).max() < 1e-6
    assert one.fps == other.fps


@settings(deadline=None, max_examples=60)
@given(
    st.integers(0, 10_000),
    st.sampled_from(UNITS),
    st.floats(1.0, 500.0),
    st.floats(-1e4, 1e4),
)
def test_a_clip_that_is_written_and_read_is_the_same(
    seed: int, unit: Unit, fps: float, far: float
) -> None:
    clip = biped_clip(3, seed)
    places = clip.pelvis_positions + np.array([far, 0.0, -far])
    clip = clip.evolve(fps=fps, pelvis_positions=places)
    assert_same(reread(clip, unit, up="y"), clip)


@settings(deadline=None, max_examples=200)
@given(
    st.floats(-np.pi, np.pi),
    st.sampled_from([-1.0, 1.0]),
    st.one_of(st.just(0.0), st.floats(-16.0, 0.0).map(lambda power: 10.0**power)),
    st.floats(-np.pi, np.pi),
)
@example(1.0, 1.0, 1e-6, 0.5)
def test_joints_at_a_right_angle_survive(
    first: float, side: float, short_of: float, last: float
) -> None:
    clip = biped_clip(1)
    rotations = clip.local_rotations.copy()
    rotations[0, 1] = from_euler("ZXY", np.array([first, side * (np.pi / 2 - short_of), last]))
    clip = clip.evolve(local_rotations=rotations)
    assert_same(reread(clip, parse_unit("m"), up="y"), clip)


def test_the_unit_and_the_upward_axis_of_what_was_written_are_found(tmp_path: Path) -> None:
    clip = biped_clip()
    for unit in UNITS:
        path = tmp_path / f"{unit.name}.bvh"
        save_bvh(clip, path, unit=unit.name)
        read, conclusions = read_bvh(path)
        assert conclusions.unit.value == unit
        assert conclusions.up.value == "y"
        assert_same(read, clip)


def test_a_packed_file_is_the_plain_one_packed(tmp_path: Path) -> None:
    save_bvh(biped_clip(), tmp_path / "walk.bvh")
    save_bvh(biped_clip(), tmp_path / "walk.bvh.gz")
    packed = (tmp_path / "walk.bvh.gz").read_bytes()
    assert gzip.decompress(packed) == (tmp_path / "walk.bvh").read_bytes()
    assert_same(load_bvh(tmp_path / "walk.bvh.gz"), biped_clip())


def test_only_the_root_has_position_channels() -> None:
    text = bvh_text(biped_clip(), parse_unit("m"), FILE)
    assert text.count("position") == 3
    assert text.count("CHANNELS 3 Zrotation Xrotation Yrotation") == 9


@pytest.mark.parametrize("name", ["", " Hips", "a{", "a}", "two\nlines", "a  b"])
def test_a_name_that_bvh_cannot_hold_is_refused(name: str) -> None:
    clip = biped_clip()
    names = ("Hips", name, *clip.skeleton.names[2:])
    skeleton = Skeleton(names, clip.skeleton.parents, clip.skeleton.rest_offsets)
    with pytest.raises(FileFormatError) as caught:
        bvh_text(clip.evolve(skeleton=skeleton), parse_unit("m"), FILE)
    assert str(caught.value) == (
        f"walk.bvh: joint name {name!r} cannot stand in a BVH file; it must not be empty, hold "
        "braces, or begin or end with a blank"
    )


def biped(
    *changes: tuple[str, str], unit: str | float | None = None, up: str | None = None
) -> Clip:
    rig = parse_bvh(biped_text(*changes).encode(), FILE)
    return clip_from_rig(rig, FILE, unit=unit, up=up)[0]


def test_the_clip_is_in_metres_and_says_where_it_is_from() -> None:
    clip = biped()
    assert clip.pelvis_positions.tolist() == [[0.0, 0.9, 0.0], [0.01, 0.91, 0.02]]
    np.testing.assert_allclose(clip.skeleton.rest_offsets[1], [0.0, 0.6, 0.0])
    np.testing.assert_allclose(clip.skeleton.tip_offsets[4], [0.0, -0.05, 0.15])
    assert clip.name == "walk"
    assert clip.provenance == (
        "read from walk.bvh: unit cm, y up, 30 frames per second, pelvis 'Hips'",
    )


def test_legs_of_nobody_make_the_reader_ask_for_the_unit() -> None:
    with pytest.raises(FileFormatError) as caught:
        biped(("-40 0", "-25 0"), ("-40 0", "-25 0"), ("-40 0", "-25 0"), ("-40 0", "-25 0"))
    assert str(caught.value) == (
        "walk.bvh: the legs are 50 long, which is a person's in no unit (50 m in m, 15.2 m in "
        "foot, 5 m in dm, 2.82 m in cmu, 1.27 m in inch, 0.5 m in cm, 0.05 m in mm); pass unit="
    )


def test_a_unit_that_is_asked_for_is_taken() -> None:
    np.testing.assert_allclose(biped(unit="inch").skeleton.rest_offsets[1], [0.0, 1.524, 0.0])
    np.testing.assert_allclose(biped(unit=0.5).skeleton.rest_offsets[1], [0.0, 30.0, 0.0])


def test_an_upward_axis_that_is_asked_for_is_taken() -> None:
    np.testing.assert_allclose(biped(up="z").pelvis_positions[1], [0.01, 0.02, -0.91])


def test_an_unknown_upward_axis_is_refused() -> None:
    with pytest.raises(ArgumentError) as caught:
        biped(up="x")
    assert str(caught.value) == "up='x' is unknown; use 'y' or 'z'"


@settings(deadline=None, max_examples=400)
@given(st.data())
def test_a_damaged_file_is_read_or_refused(data: st.DataObject) -> None:
    text = BIPED
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        length = data.draw(st.sampled_from([0, 1, 2, 5, 30, 400]))
        new = data.draw(
            st.one_of(
                st.text(alphabet="{}\n\t 019.-+eEnaifXYZ\x00é", max_size=6),
                st.sampled_from(
                    [
                        "nan",
                        "1e308",
                        "-1e11",
                        "0",
                        "\n",
                        "{",
                        "}",
                        "JOINT",
                        "CHANNELS 0",
                        "Frames: 1",
                    ]
                ),
            )
        )
        text = text[:start] + new + text[start + length :]
    with suppress(FileFormatError):
        clip_from_rig(parse_bvh(text.encode(), FILE), FILE)


@settings(deadline=None, max_examples=200)
@given(st.data())
def test_any_numbers_are_read_or_refused(data: st.DataObject) -> None:
    """The shape is right, and every number is anything at all."""
    number = st.one_of(st.floats(-2e12, 2e12), st.sampled_from([0.0, 1e-300, 1e11, -1e11]))
    lines: list[str] = [*BIPED.split("\n")]
    for index, line in enumerate(lines):
        words = line.split()
        if words[:1] == ["OFFSET"] and data.draw(st.booleans()):
            lines[index] = "OFFSET " + " ".join(repr(data.draw(number)) for _ in range(3))
        elif len(words) == 21 and data.draw(st.booleans()):
            lines[index] = " ".join(repr(data.draw(number)) for _ in range(21))
    unit = data.draw(st.sampled_from([None, "cm", 1e8]))
    up = data.draw(st.sampled_from([None, "y", "z"]))
    with suppress(FileFormatError):
        clip_from_rig(parse_bvh("\n".join(lines).encode(), FILE), FILE, unit=unit, up=up)


@settings(deadline=None, max_examples=100)
@given(st.binary(max_size=60))
def test_any_bytes_are_refused(data: bytes) -> None:
    with pytest.raises(FileFormatError):
        parse_bvh(data, FILE)
