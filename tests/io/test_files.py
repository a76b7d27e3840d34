from __future__ import annotations

import gzip
import os
from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import BIPED, biped_clip

from footfall.errors import ArgumentError, FileFormatError
from footfall.io import (
    load,
    load_supports,
    load_with_conclusions,
    save,
    save_native,
    save_supports,
)
from footfall.io.motion_formats import READERS, WRITERS
from footfall.support import SupportSequence

WALK = SupportSequence.parse("R.4 D.1 L.4 D.1*")


@pytest.mark.parametrize("name", ["a.bvh", "a.BVH", "a.bvh.gz", "a.b.npz"])
def test_what_is_saved_is_loaded(tmp_path: Path, name: str) -> None:
    clip = biped_clip()
    save(clip, tmp_path / name)
    read = load(str(tmp_path / name))
    assert read.skeleton.same_family(clip.skeleton)
    np.testing.assert_allclose(read.world_poses()[1], clip.world_poses()[1], atol=1e-6)


def test_a_glb_is_written(tmp_path: Path) -> None:
    save(biped_clip(), tmp_path / "a.glb")
    assert (tmp_path / "a.glb").read_bytes()[:4] == b"glTF"


def test_a_file_of_ours_says_everything_itself(tmp_path: Path) -> None:
    save(biped_clip().evolve(cyclic=True), tmp_path / "a.npz")
    clip, conclusions = load_with_conclusions(tmp_path / "a.npz")
    assert clip.cyclic
    assert dict(conclusions.sentences()) | {"feet": "", "floor": "", "first frame": ""} == {
        "unit": "m, as always in this format",
        "up": "y, as always in this format",
        "root": "'Hips', joint 0 of the file",
        "bones": "fixed, as always in this format",
        "frames": "8, as the file holds",
        "fps": "30 frames per second, as the file says",
        "feet": "",
        "first frame": "",
        "floor": "",
        "cyclic": "cyclic, as the file says",
    }


@pytest.mark.parametrize("known", [{"unit": "cm"}, {"up": "y"}, {"fps": 30.0}])
def test_a_file_of_ours_wants_no_help(tmp_path: Path, known: dict[str, object]) -> None:
    path = tmp_path / "a.npz"
    save(biped_clip(), path)
    with pytest.raises(ArgumentError) as caught:
        load(path, **known)  # type: ignore[arg-type]
    assert str(caught.value) == (
        f"{path} knows its unit, upward axis and rate; unit=, up= and fps= are for other files"
    )


def refusal(path: Path) -> str:
    with pytest.raises(FileFormatError) as caught:
        load(path)
    return str(caught.value).removeprefix(str(path.parent) + os.sep)


def test_an_unknown_suffix_is_refused_with_those_known(tmp_path: Path) -> None:
    readable = ", ".join(sorted(READERS))
    assert refusal(tmp_path / "walk.xyz") == (
        f"walk.xyz: cannot be read as a motion: its suffix is none of {readable}"
    )
    with pytest.raises(FileFormatError) as caught:
        save(biped_clip(), tmp_path / "walk")
    assert str(caught.value) == (
        f"{tmp_path / 'walk'}: cannot be written: its suffix is none of "
        f"{', '.join(sorted(WRITERS))}"
    )
    assert not list(tmp_path.iterdir())


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    assert refusal(tmp_path / "walk.bvh") == "walk.bvh: there is no such file; check the name"


def test_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "walk.bvh").mkdir()
    assert refusal(tmp_path / "walk.bvh") == "walk.bvh: it is a folder; name a file"


def test_a_name_that_cannot_be_one_is_refused(tmp_path: Path) -> None:
    assert refusal(tmp_path / "a\0.bvh") == "a\0.bvh: is no name of a file: embedded null byte"


@pytest.mark.parametrize("data", [b"", BIPED.encode(), gzip.compress(BIPED.encode())[:-9]])
def test_a_damaged_packed_file_is_refused(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "walk.bvh.gz").write_bytes(data)
    message = {
        True: "walk.bvh.gz: is empty; a BVH file begins with HIERARCHY",
        False: "walk.bvh.gz: is not a whole gzip file; fetch it again, or unpack it first",
    }
    assert refusal(tmp_path / "walk.bvh.gz") == message[data == b""]


def test_supports_are_read_from_text_and_from_files_of_ours(tmp_path: Path) -> None:
    save_supports(WALK, tmp_path / "walk.supports")
    save_native(biped_clip(), tmp_path / "walk.npz", supports=WALK)
    assert load_supports(tmp_path / "walk.supports") == WALK
    assert load_supports(str(tmp_path / "walk.npz")) == WALK


def test_a_motion_without_supports_is_told(tmp_path: Path) -> None:
    path = tmp_path / "walk.npz"
    save(biped_clip(), path)
    with pytest.raises(FileFormatError) as caught:
        load_supports(path)
    assert str(caught.value) == f"{path}: holds a motion without supports; detect them"


def test_supports_have_suffixes_of_their_own(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        load_supports(tmp_path / "walk.txt")
    assert str(caught.value) == (
        f"{tmp_path / 'walk.txt'}: cannot be read as supports: its suffix is none of "
        ".csv, .npz, .parquet, .supports"
    )
    with pytest.raises(FileFormatError) as caught:
        save_supports(WALK, tmp_path / "walk.npz")
    assert str(caught.value) == (
        f"{tmp_path / 'walk.npz'}: cannot be written as supports: its suffix is none of "
        ".csv, .parquet, .supports"
    )
