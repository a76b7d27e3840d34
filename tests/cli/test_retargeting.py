"""`footfall retarget`, and what `footfall info` says of a body."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import footfall as ff
from footfall.cli import main
from footfall.io import load_skinned, save, save_gltf

Captured = pytest.CaptureFixture[str]


def test_a_motion_is_played_on_the_body_of_another_file(tmp_path: Path, capsys: Captured) -> None:
    walk, supports = ff.sample("walk")
    body, out = tmp_path / "body.bvh", tmp_path / "out.bvh"
    save(walk, body)
    assert main(["retarget", "sample:run", "--body", str(body), "-o", str(out)]) == 0
    told = capsys.readouterr().out
    assert told.startswith(f"{out}: supports ")
    assert "  map: " in told
    assert "drift mm" in told
    assert (tmp_path / "out.supports").exists()
    assert supports.cyclic
    assert ff.load(out).skeleton.names == walk.skeleton.names


def test_a_skinned_character_performs_and_keeps_its_skin(tmp_path: Path) -> None:
    walk, _ = ff.sample("walk")
    run, _ = ff.sample("run")
    character, out = tmp_path / "character.glb", tmp_path / "out.glb"
    save_gltf(walk, character)
    assert main(["retarget", "sample:run", "--body", str(character), "-o", str(out)]) == 0
    before, after = load_skinned(character), load_skinned(out)
    assert np.array_equal(before.triangles, after.triangles)
    assert after.skeleton.same_family(before.skeleton)
    assert ff.load(out).duration == pytest.approx(run.duration, abs=0.05)


def test_a_body_that_is_no_file_is_named(tmp_path: Path, capsys: Captured) -> None:
    out = tmp_path / "out.glb"
    missing = tmp_path / "nobody.glb"
    assert main(["retarget", "sample:walk", "--body", str(missing), "-o", str(out)]) != 0
    assert "nobody.glb" in capsys.readouterr().err
    assert not out.exists()


def test_info_tells_the_body_map_and_why(tmp_path: Path, capsys: Captured) -> None:
    walk, _ = ff.sample("walk")
    path = tmp_path / "walk.bvh"
    save(walk, path)
    assert main(["info", str(path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    start = lines.index("body map, by which motions of other bodies are played on this one:")
    told = [line.split(maxsplit=2) for line in lines[start + 1 :]]
    assert lines[start + 1].split()[0] == "pelvis"
    assert any(line.strip().startswith("left leg") for line in lines[start:])
    assert sum(words[0] == "because" for words in told) >= 6
