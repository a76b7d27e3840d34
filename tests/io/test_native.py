from __future__ import annotations

import io
import json
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.io.small_biped import biped_clip

from footfall.errors import FileFormatError
from footfall.io import load_native, load_native_supports, save_native
from footfall.motion import Clip
from footfall.support import SupportPhase, SupportSequence
from footfall.support.algebra import Support

SUPPORTS = SupportSequence(
    (SupportPhase(Support.RIGHT, 1 / 3), SupportPhase(Support.LEFT, 0.1)), True, -0.05
)


def stored(tmp_path: Path) -> tuple[Path, dict[str, Any]]:
    path = tmp_path / "walk.npz"
    save_native(biped_clip(), path, supports=SUPPORTS)
    with np.load(path) as arrays:
        return path, dict(arrays)


def rewritten(path: Path, arrays: dict[str, Any], **header: object) -> Path:
    """Write the arrays with parts of the header replaced."""
    known: dict[str, Any] = json.loads(arrays["header"].tobytes())
    packed = np.frombuffer(json.dumps(known | header).encode(), dtype=np.uint8)
    entries: Any = arrays | {"header": packed}
    np.savez(path, **entries)
    return path


def test_every_number_comes_back(tmp_path: Path) -> None:
    clip = biped_clip().evolve(fps=1 / 0.0333333, cyclic=True, name="é", provenance=("a", "b"))
    save_native(clip, tmp_path / "walk.npz", supports=SUPPORTS)
    read = load_native(tmp_path / "walk.npz")
    assert read.skeleton.names == clip.skeleton.names
    for one, other in (
        (read.skeleton.parents, clip.skeleton.parents),
        (read.skeleton.rest_offsets, clip.skeleton.rest_offsets),
        (read.skeleton.tip_offsets, clip.skeleton.tip_offsets),
        (read.pelvis_positions, clip.pelvis_positions),
        (read.local_rotations, clip.local_rotations),
    ):
        assert one.tobytes() == other.tobytes()
    assert (read.fps, read.cyclic, read.name, read.provenance) == (clip.fps, True, "é", ("a", "b"))
    assert load_native_supports(tmp_path / "walk.npz") == SUPPORTS


def test_a_clip_without_supports_has_none(tmp_path: Path) -> None:
    save_native(biped_clip(), tmp_path / "walk.npz")
    assert load_native_supports(tmp_path / "walk.npz") is None


def test_the_same_clip_makes_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one.npz", "two.npz"):
        save_native(biped_clip(), tmp_path / name, supports=SUPPORTS)
    assert (tmp_path / "one.npz").read_bytes() == (tmp_path / "two.npz").read_bytes()


def refusal(path: Path) -> str:
    with pytest.raises(FileFormatError) as caught:
        load_native(path)
    return str(caught.value)


def test_another_version_is_refused(tmp_path: Path) -> None:
    path = rewritten(*stored(tmp_path), version=2)
    assert refusal(path) == f"{path}: is of version 2; this program reads version 1"


def test_another_format_is_refused(tmp_path: Path) -> None:
    path = rewritten(*stored(tmp_path), format="other")
    assert refusal(path) == (
        f"{path}: is no clip of this project: its header is not 'footfall clip'"
    )


def test_arrays_of_somebody_else_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.npz"
    np.savez(path, a=np.zeros(3))
    assert refusal(path) == f"{path}: is no clip of this project: it has no header"


def test_a_broken_clip_is_refused(tmp_path: Path) -> None:
    path, arrays = stored(tmp_path)
    arrays["local_rotations"] = arrays["local_rotations"] * 2.0
    rewritten(path, arrays)
    assert refusal(path) == (
        f"{path}: clip 'biped': the rotation of 'Hips' in frame 0 has length 2.000000; "
        "unit quaternions are needed"
    )


def test_broken_supports_are_refused(tmp_path: Path) -> None:
    phases = {"phases": [["R", 0.1], ["R", 0.1]], "cyclic": False, "start": 0.0}
    path = rewritten(*stored(tmp_path), supports=phases)
    with pytest.raises(FileFormatError) as caught:
        load_native_supports(path)
    assert str(caught.value) == (
        f"{path}: its supports: phases 0 and 1 are both RIGHT; merge them into one"
    )


@pytest.mark.parametrize(
    "header",
    [
        {"names": None},
        {"names": "Hips"},
        {"names": [1] * 10},
        {"fps": "fast"},
        {"fps": None},
        {"fps": -1},
        {"provenance": 3},
        {"version": [1]},
    ],
)
def test_a_header_with_something_else_in_it_is_refused(
    tmp_path: Path, header: dict[str, object]
) -> None:
    assert "\n" not in refusal(rewritten(*stored(tmp_path), **header))


@pytest.mark.parametrize("name", ["parents", "rest_offsets", "pelvis_positions", "local_rotations"])
@pytest.mark.parametrize(
    "array",
    [np.zeros(0), np.zeros((2, 2)), np.array("text"), np.full((8, 3), np.nan), np.zeros(())],
    ids=["empty", "square", "text", "nan", "scalar"],
)
def test_an_array_of_another_shape_is_refused(tmp_path: Path, name: str, array: Any) -> None:
    path, arrays = stored(tmp_path)
    assert "\n" not in refusal(rewritten(path, arrays | {name: array}))


def test_pickled_objects_are_never_loaded(tmp_path: Path) -> None:
    path, arrays = stored(tmp_path)
    rewritten(path, arrays | {"parents": np.array([{}], dtype=object)})
    assert refusal(path).startswith(f"{path}: is damaged or no clip of this project: ")


@settings(
    deadline=None, max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.data())
def test_a_damaged_file_is_read_or_refused(tmp_path: Path, data: st.DataObject) -> None:
    path = tmp_path / "walk.npz"
    save_native(biped_clip(2), path, supports=SUPPORTS)
    content = bytearray(path.read_bytes())
    for _ in range(data.draw(st.integers(1, 3))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    end = data.draw(st.one_of(st.just(len(content)), st.integers(0, len(content))))
    path.write_bytes(content[:end])
    with suppress(FileFormatError):
        clip = load_native(path)
        assert isinstance(clip, Clip)
    with suppress(FileFormatError):
        load_native_supports(path)


def test_the_arrays_are_plain(tmp_path: Path) -> None:
    path, arrays = stored(tmp_path)
    assert sorted(arrays) == [
        "header", "local_rotations", "parents", "pelvis_positions", "rest_offsets", "tip_offsets",
    ]  # fmt: skip
    assert json.loads(arrays["header"].tobytes())["version"] == 1
    np.load(io.BytesIO(path.read_bytes()), allow_pickle=False).close()
