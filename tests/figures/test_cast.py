from __future__ import annotations

from pathlib import Path

import pytest

from footfall.errors import ArgumentError, UnknownNameError
from footfall.figures import ROLES, Cast
from footfall.io import save
from footfall.samples import sample, sample_names

REAL = Path(__file__).parents[3] / "shared" / "motions"


def test_samples_play_all_parts() -> None:
    cast = Cast.of_samples()
    assert set(cast.motions) == set(ROLES)
    assert {role.sample for role in ROLES.values()} <= set(sample_names())
    assert cast.motion("run").clip is sample("run")[0]
    assert not cast.origins


def test_there_is_no_such_part() -> None:
    with pytest.raises(UnknownNameError) as caught:
        Cast.of_samples().motion("dance")
    assert str(caught.value).startswith("no part named 'dance'")


def test_files_play_the_parts_that_their_names_say(tmp_path: Path) -> None:
    for name, played in (
        ("Walk.bvh", "walk"),
        ("walk_fast_02.bvh", "walk-fast"),
        ("my_walk_that_is_long.bvh", "walk-slow"),
        ("fast-walk-to-hop.bvh", "walk-to-hop"),
        ("notes.txt", "walk"),
    ):
        clip, _ = sample(played)
        if name.endswith(".bvh"):
            save(clip, tmp_path / name)
        else:
            (tmp_path / name).write_text("walk")
    cast = Cast.of_folder(tmp_path)
    assert cast.origins == {
        "walk": "Walk.bvh",
        "fast walk": "walk_fast_02.bvh",
        "walk to hop": "fast-walk-to-hop.bvh",
    }
    assert cast.motion("run").clip.duration == sample("run")[0].duration


def test_a_file_plays_only_the_part_that_its_name_says_most_of(tmp_path: Path) -> None:
    save(sample("walk-fast")[0], tmp_path / "walk_fast.bvh")
    assert Cast.of_folder(tmp_path).origins == {"fast walk": "walk_fast.bvh"}


def test_a_file_that_cannot_play_is_passed_over(tmp_path: Path) -> None:
    (tmp_path / "run.bvh").write_text("HIERARCHY nonsense")
    save(sample("run")[0], tmp_path / "run_again.bvh")
    save(sample("idle")[0], tmp_path / "kick.bvh")
    assert Cast.of_folder(tmp_path).origins == {"run": "run_again.bvh"}


def test_a_folder_without_motions_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ArgumentError) as caught:
        Cast.of_folder(tmp_path)
    assert str(caught.value) == (
        f"{tmp_path} holds no motion of a biped that plays a part; name .bvh, .bvh.gz, .npz files "
        "after the parts: walk, fast walk, back walk, run, side step, right hop, left hop, kick, "
        "jump, shot, walk to hop"
    )
    with pytest.raises(ArgumentError) as caught:
        Cast.of_folder(tmp_path / "missing")
    assert str(caught.value) == (
        f"--motions is {tmp_path / 'missing'}; it must be a folder with motions"
    )


@pytest.mark.full
@pytest.mark.skipif(not REAL.exists(), reason="no ../shared/motions")
def test_real_clips_of_many_bodies_play_on_one() -> None:
    cast = Cast.of_folder(REAL)
    assert {"walk", "fast walk", "back walk", "run", "side step", "jump"} <= set(cast.origins)
    bodies = {motion.clip.skeleton.names for motion in cast.motions.values()}
    assert len(bodies) == 1
