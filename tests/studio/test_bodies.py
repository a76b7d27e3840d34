"""Whoever performs: other sizes, other skeletons, characters in their skin."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from footfall.errors import FileFormatError
from footfall.io import load_skinned, save_gltf, save_native
from footfall.motion import Clip
from footfall.samples import sample
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import perform
from footfall.skeleton import Skeleton
from footfall.studio.bodies import Wardrobe, bodies_of, standing_clip
from footfall.studio.motion_list import MotionList
from footfall.studio.stage import Stage
from footfall.studio.take import scenario_text
from footfall.studio.work_folder import WorkFolder

WALK = sample("walk")[0]


def with_a_tail(skeleton: Skeleton) -> Skeleton:
    """Return another family: the same body, 10 % larger, with one more joint."""
    return Skeleton(
        (*skeleton.names, "Tail"),
        np.append(skeleton.parents, 0),
        np.concatenate([1.1 * skeleton.rest_offsets, [[0.0, 0.0, -0.2]]]),
        np.concatenate([1.1 * skeleton.tip_offsets, [[0.0, 0.0, -0.1]]]),
    )


def motions(folder: Path, *names: str) -> MotionList:
    found = MotionList(WorkFolder.at(folder))
    for name in names:
        found.keep(found.resolve(f"sample:{name}"))
    return found


def test_sizes_keep_the_family_and_change_the_bones() -> None:
    own, child, tall, long_legs = bodies_of([WALK.skeleton])
    assert own.skeleton is None
    for body, factor in ((child, 0.72), (tall, 1.14)):
        assert body.skeleton is not None
        assert body.skeleton.same_family(WALK.skeleton)
        np.testing.assert_allclose(body.skeleton.rest_offsets, factor * WALK.skeleton.rest_offsets)
    assert long_legs.skeleton is not None
    longer = np.linalg.norm(long_legs.skeleton.rest_offsets - WALK.skeleton.rest_offsets, axis=-1)
    assert (longer > 0.01).sum() >= 4
    assert bodies_of([]) == ()


def test_a_body_of_another_family_performs_and_its_take_replays_bit_for_bit(
    tmp_path: Path,
) -> None:
    loaded = motions(tmp_path, "walk", "run")
    body = with_a_tail(WALK.skeleton)
    loaded.body = body
    mine = Stage(loaded)
    assert [card.name for card in mine.cards] == ["walk", "run"]
    mine.start(mine.cards[0])
    for frame in range(200):
        mine.advance()
        if frame == 90:
            mine.start(mine.cards[1])
    performer = mine.pair()[0]
    assert performer.skeleton.count == WALK.skeleton.count + 1
    assert performer.slip.total < 0.05
    save_native(standing_clip(body), tmp_path / "body.npz")
    sheet = replace(mine.scenario(), body="body.npz")
    recording = perform(parse_scenario(scenario_text(sheet), tmp_path / "take.toml")).recording
    np.testing.assert_array_equal(recording.world_positions[-1], performer.positions)
    np.testing.assert_array_equal(recording.world_rotations[-1], performer.rotations)


def test_motions_of_several_families_mix_on_the_first_body(tmp_path: Path) -> None:
    other = with_a_tail(WALK.skeleton)
    still = np.tile([1.0, 0.0, 0.0, 0.0], (WALK.frames, 1, 1))
    rotations = np.concatenate([WALK.local_rotations, still], axis=1)
    save_native(
        Clip(other, 1.1 * WALK.pelvis_positions, rotations, WALK.fps), tmp_path / "tail.npz"
    )
    loaded = motions(tmp_path, "run")
    tail = loaded.resolve("tail.npz")
    loaded.prepare(tail)
    loaded.keep(tail)
    assert [one.name for one in loaded.family] == ["run", "tail"]
    assert loaded.performed[1][1].skeleton.same_family(loaded.performed[0][1].skeleton)
    assert len(loaded.skeletons) == 2


def test_a_motion_is_retargeted_once(tmp_path: Path) -> None:
    loaded = motions(tmp_path, "walk")
    loaded.body = with_a_tail(WALK.skeleton)
    assert loaded.performed[0][1] is loaded.performed[0][1]
    assert MotionList(loaded.folder, loaded).motions == loaded.motions


def test_a_skin_is_read_once_as_long_as_its_file_stays(tmp_path: Path) -> None:
    path = tmp_path / "hero.glb"
    save_gltf(WALK, path)
    wardrobe = Wardrobe()
    first = wardrobe.body(path, "hero.glb")
    assert first.skin is not None
    assert first.skeleton is first.skin.skeleton
    assert first.skin.skeleton.count == load_skinned(path).skeleton.count
    assert wardrobe.body(path, "hero.glb") is first
    os.utime(path, (1.0, 1.0))
    assert wardrobe.body(path, "hero.glb") is not first
    with pytest.raises(FileFormatError):
        wardrobe.body(tmp_path / "none.glb", "none.glb")
