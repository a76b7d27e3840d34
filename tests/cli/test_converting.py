"""`convert` writes every form of file, and plays the motion on another body on the way."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import footfall as ff
from footfall.cli import main
from footfall.io import load_skinned, readable_suffixes, save_gltf, writable_suffixes
from footfall.io.gltf_buffers import glb_bytes
from footfall.io.gltf_document import read_document
from footfall.skeleton import Skeleton

Captured = pytest.CaptureFixture[str]


def test_its_help_names_every_suffix(capsys: Captured) -> None:
    main(["convert", "--help"])
    words = capsys.readouterr().out.replace("│", " ").split()
    # Between two columns a suffix may be cut in two.
    told = "".join(words)
    for suffixes in (readable_suffixes(), writable_suffixes()):
        assert f"({','.join(suffixes)})" in told


def test_on_another_body_it_is_what_retarget_writes(tmp_path: Path, capsys: Captured) -> None:
    source, body = tmp_path / "walk.npz", tmp_path / "tall.npz"
    assert main(["convert", "sample:walk", str(source)]) == 0
    clip, _ = ff.sample("idle")
    tall = Skeleton(
        clip.skeleton.names,
        clip.skeleton.parents,
        1.2 * clip.skeleton.rest_offsets,
        1.2 * clip.skeleton.tip_offsets,
    )
    ff.save(clip.evolve(skeleton=tall, pelvis_positions=1.2 * clip.pelvis_positions), body)
    one, other = tmp_path / "one.npz", tmp_path / "other.npz"
    assert main(["convert", str(source), str(one), "--body", str(body)]) == 0
    assert "legs 1.200 times as long" in capsys.readouterr().out
    assert main(["retarget", str(source), "--body", str(body), "-o", str(other)]) == 0
    np.testing.assert_array_equal(ff.load(one).world_poses()[1], ff.load(other).world_poses()[1])
    assert (tmp_path / "one.supports").read_text() == (tmp_path / "walk.supports").read_text()


def save_bare(path: Path) -> None:
    """Take the animations out of a .glb file."""
    document = read_document(path)
    content = dict(document.root.content)
    del content["animations"]
    data = document.buffers[0]
    assert data is not None
    path.write_bytes(glb_bytes(content, data))


@pytest.mark.parametrize("moves", [True, False])
def test_a_character_keeps_its_skin(tmp_path: Path, moves: bool) -> None:
    idle, _ = ff.sample("idle")
    path, out = tmp_path / "character.glb", tmp_path / "out.glb"
    save_gltf(idle, path)
    body = load_skinned(path)
    if not moves:
        save_bare(path)
    assert main(["convert", "sample:walk", str(out), "--body", str(path)]) == 0
    written = load_skinned(out)
    np.testing.assert_array_equal(written.triangles, body.triangles)
    np.testing.assert_allclose(written.anchors, body.anchors, atol=1e-6)
    assert ff.load(out).frames == ff.sample("walk")[0].frames
    assert (tmp_path / "out.supports").exists()


def test_a_body_that_cannot_perform_it_is_named_and_nothing_written(
    tmp_path: Path, capsys: Captured
) -> None:
    text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n}\n"
    (tmp_path / "a.bvh").write_text(f"{text}MOTION\nFrames: 2\nFrame Time: 0.1\n1 2 3\n4 5 6\n")
    out = tmp_path / "out.npz"
    assert main(["convert", "sample:walk", str(out), "--body", str(tmp_path / "a.bvh")]) == 2
    assert capsys.readouterr().err.startswith(f"footfall: {tmp_path / 'a.bvh'}: ")
    assert list(tmp_path.iterdir()) == [tmp_path / "a.bvh"]
