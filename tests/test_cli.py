"""The commands do what they say, and tell in one line what is wrong with their input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import footfall as ff
from footfall.cli import main
from footfall.io import load_skinned, save_gltf, save_skinned
from footfall.io.motion_formats import WRITERS
from footfall.samples import sample_names
from footfall.scenario.methods import METHODS

SHEET = """
duration = 0.5
[[action]]
name = "walk"
motion = "sample:walk"
[[cue]]
at = 0.1
start = "walk"
"""

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def sheet(tmp_path: Path) -> Path:
    path = tmp_path / "sheet.toml"
    path.write_text(SHEET)
    return path


WRONG = {
    "edit sample:trot out.bvh": ("no sample named 'trot'; there are: " + ", ".join(sample_names())),
    "edit sample:walk out.xyz": (
        f"out.xyz: cannot be written: its suffix is none of {', '.join(sorted(WRITERS))}"
    ),
    "edit sample:walk no/out.bvh": "no/out.bvh: there is no folder no; make it first",
    "edit sample:kick out.bvh --crop 1": (
        "--crop is '1'; it must be two times in seconds, such as 0.5:1.8"
    ),
    "edit sample:kick out.bvh --crop 1:90": (
        "sample:kick: clip 'kick': the crop's end is 90 s; it must be within 0..2.1 s"
    ),
    "convert sample:walk out.txt": (
        "out.txt: cannot be written: DeepMimic's body has the joints root, chest, neck, right_hip, "
        "right_knee, right_ankle, right_shoulder, right_elbow, right_wrist, left_hip, left_knee, "
        "left_ankle, left_shoulder, left_elbow, left_wrist; this one has Hips, Spine, Spine1, "
        "Spine2, Neck, Head, LeftShoulder, LeftArm, ...; retarget the motion onto it first"
    ),
    "convert sample:walk out.bvh --unit cm": "sample:walk is no file; --unit is for files",
    "info none.bvh --unit 2x": "--unit is '2x'; it must be a unit's name or a number of metres",
    "info none.bvh": "none.bvh: there is no such file; check the name",
    "blend none.toml -o out.bvh": "none.toml: there is no such file; check the name",
    "report none.toml": "none.toml: there is no such file; check the name",
    "detect sample:walk --height -1": (
        "sample:walk: height is -1.0; a limit must be finite and > 0"
    ),
    "sync": 'no sequences; give at least one, such as "R D L D*", or --batch FILE',
    "sync R* --start a": "--start is 'a'; it must be slot numbers such as 0,1",
    "sync X": (
        "sequences[0], 'X': 'X' in 'X' is no support phase; write R, L, D or -, with its "
        "seconds if wanted, such as R.38, and * at the very end for a cycle"
    ),
    "demo --motions none": "--motions is none; it must be a folder with motions",
    "blend": 'Command "blend" parameter SCENARIO requires an argument.',
}


@pytest.mark.parametrize("words", WRONG)
def test_wrong_input_is_told_in_one_line_and_nothing_is_written(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(words.split()) == 2
    out, err = capsys.readouterr()
    assert (out, err) == ("", f"footfall: {WRONG[words]}\n")
    assert list(tmp_path.iterdir()) == []


def test_info_tells_what_was_concluded_and_why(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "walk.bvh"
    ff.save(ff.sample("walk")[0], path)
    assert main(["info", str(path), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["fps"], told["frames"], told["unit"], told["cyclic"]) == (60.0, 65, "m", True)
    assert set(told["feet"]) == {"left", "right"}
    assert set(told["reasons"]) >= {"unit", "up", "root", "fps", "feet", "floor", "cyclic"}


def test_info_tells_whether_hands_carry(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "walk.bvh"
    ff.save(ff.sample("walk")[0], path)
    assert main(["info", str(path)]) == 0
    assert "hands        never on the ground: the feet alone carry\n" in capsys.readouterr().out


def test_detect_counts_the_hands_where_asked_to(capsys: Captured) -> None:
    assert main(["detect", "sample:run", "--limbs", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert {phase["support"] for phase in told["phases"]} == {"R", "-", "L"}
    assert set(told["supports"].split(" ")) == {"R", "-", "L"}
    assert main(["detect", "sample:run", "--limbs", "--height", "0.1"]) == 2
    assert capsys.readouterr().err == (
        "footfall: sample:run: --height and --speed are the limits of a foot; "
        "--limbs has limits of its own\n"
    )


def test_detect_writes_supports_that_are_read_again(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "run.supports"
    assert main(["detect", "sample:run", "-o", str(path)]) == 0
    assert capsys.readouterr().out.startswith(f"{path}: ")
    symbols = [phase.support.symbol for phase in ff.load_supports(path).phases]
    assert symbols == ["R", "-", "L", "-"]


def test_edit_crops_mirrors_and_resamples(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "out.npz"
    words = f"edit sample:kick {path} --crop 0.5:1.5 --mirror --resample 30"
    assert main(words.split()) == 0
    clip = ff.load(path)
    assert (clip.frames, clip.fps) == (31, 30.0)
    assert capsys.readouterr().out.splitlines()[0] == f"{path}: 31 frames, 1.000 s, 30 per second"


def test_edit_lets_travel_what_was_captured_in_place(tmp_path: Path, capsys: Captured) -> None:
    walk, _ = ff.sample("walk")
    still, out = tmp_path / "still.glb", tmp_path / "out.bvh"
    save_gltf(walk.evolve(pelvis_positions=walk.pelvis_positions * [0.0, 1.0, 0.0]), still)
    assert main(["edit", str(still), str(out), "--travel"]) == 0
    assert "  taken along by its carrying feet, 1.400 m at 1.31 m/s; " in capsys.readouterr().out
    clip = ff.load(out)
    assert clip.pelvis_positions[-1, 2] - clip.pelvis_positions[0, 2] == pytest.approx(
        1.4, abs=2e-3
    )
    assert main(["edit", str(out), str(tmp_path / "again.bvh"), "--travel"]) == 2
    assert "is not in place" in capsys.readouterr().err
    assert not (tmp_path / "again.bvh").exists()


def test_clean_writes_the_motion_and_its_supports(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "clean.npz"
    assert main(["clean", "sample:walk", "-o", str(path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in lines[-2:]] == ["  slip before", "  slip after"]
    assert sorted(one.name for one in tmp_path.iterdir()) == ["clean.npz", "clean.supports"]


def test_supports_of_another_motion_are_neither_used_nor_left_beside_it(
    tmp_path: Path, capsys: Captured
) -> None:
    walk, other = tmp_path / "walk.bvh", tmp_path / "other.bvh"
    assert main(["edit", "sample:walk", str(walk)]) == 0
    (tmp_path / "other.supports").write_text("once\nR 0.5\n")
    before = walk.read_bytes()
    capsys.readouterr()
    assert main(["edit", str(walk), str(other), "--mirror"]) == 2
    assert capsys.readouterr().err == (
        f"footfall: {other}: would stand beside other.supports, which is of another motion; "
        "delete that file, or choose another name\n"
    )
    assert not other.exists()
    (tmp_path / "walk.supports").write_text("once\nR 0.5\n")
    assert main(["report", str(walk)]) == 2
    assert capsys.readouterr().err == (
        f"footfall: {walk}: lasts 1.067 s, the supports that travel with it 0.500 s; they are "
        "another motion's: delete walk.supports, or detect anew\n"
    )
    assert walk.read_bytes() == before


def test_sync_answers_in_json(capsys: Captured) -> None:
    words = ["sync", "R D L D*", "- R L", "--start", "0,1", "--slots", "4", "--planner", "paper"]
    assert main([*words, "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert set(answer) == {"result", "rows", "started", "durations", "muted", "error"}
    assert len(answer["result"]) == 4


def test_sync_answers_a_batch_line_by_line(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "problems.jsonl"
    path.write_text('{"sequences": ["R L*"], "slots": 3}\nnone\n')
    assert main(["sync", "--batch", str(path)]) == 0
    answers = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert answers[0]["result"] == ["R", "L", "R"]
    assert answers[1] == {"error": "not JSON at column 1: Expecting value"}


def test_report_measures_a_motion_in_its_supports(capsys: Captured) -> None:
    assert main(["report", "sample:walk", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["fps"], told["frames"], len(told["supports"])) == (60.0, 65, 65)
    assert list(told["rows"]) == ["clip"]
    assert told["rows"]["clip"]["slip_mm"]["max"] < 2.0


def test_blend_writes_motion_supports_and_figures(
    sheet: Path, tmp_path: Path, capsys: Captured
) -> None:
    path, figures = tmp_path / "out.npz", tmp_path / "figures.json"
    assert main(["blend", str(sheet), "-o", str(path), "--json", str(figures)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"{path}: 31 frames, 0.500 s",
        "  walk: commanded at 0.10 s, started at once",
    ]
    told = json.loads(figures.read_text())
    assert (told["fps"], told["frames"], len(told["supports"])) == (60.0, 31, 31)
    assert told["starts"] == [{"action": "walk", "commanded": 0.1, "actual": 0.1, "reason": ""}]
    assert list(told["rows"]) == list(METHODS)
    assert ff.load_supports(tmp_path / "out.supports").duration == pytest.approx(0.5)


def test_convert_carries_the_supports_along(tmp_path: Path, capsys: Captured) -> None:
    assert main(["convert", "sample:walk", str(tmp_path / "a.npz")]) == 0
    assert main(["convert", str(tmp_path / "a.npz"), str(tmp_path / "b.glb")]) == 0
    assert main(["convert", f"{tmp_path / 'b.glb'}#0", str(tmp_path / "c.bvh")]) == 0
    told = capsys.readouterr().out
    assert told.count("supports as they came with the motion: ") == 2
    wanted = ff.load(tmp_path / "a.npz")
    assert (tmp_path / "b.supports").read_text() == (tmp_path / "a.supports").read_text()
    for name in ("b.glb", "c.bvh"):
        read = ff.load(tmp_path / name)
        assert read.frames == wanted.frames
        assert abs(read.world_poses()[1] - wanted.world_poses()[1]).max() < 1e-5


def test_what_a_file_does_not_say_is_said_by_an_option(tmp_path: Path, capsys: Captured) -> None:
    text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n}\n"
    (tmp_path / "a.bvh").write_text(f"{text}MOTION\nFrames: 2\nFrame Time: 0.1\n1 2 3\n4 5 6\n")
    known = ["--unit", "0.1", "--up", "y", "--fps", "20"]
    assert main(["info", str(tmp_path / "a.bvh")]) == 2
    assert main(["info", str(tmp_path / "a.bvh"), "--json", *known]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["fps"], told["metres_per_unit"], told["up"]) == (20.0, 0.1, "y")
    source, target = str(tmp_path / "a.bvh"), tmp_path / "b.npz"
    for command in (["convert", source, str(target)], ["edit", source, str(target)]):
        assert main([*command, *known]) == 0
        assert ff.load(target).pelvis_positions[1].tolist() == pytest.approx([0.4, 0.5, 0.6])


def test_info_lists_the_animations_of_a_file(tmp_path: Path, capsys: Captured) -> None:
    clip, _ = ff.sample("walk")
    save_gltf(clip, tmp_path / "one.glb")
    body = load_skinned(tmp_path / "one.glb")
    save_skinned(body, [clip, clip.evolve(name="again")], tmp_path / "two.glb")
    assert main(["info", str(tmp_path / "two.glb")]) == 0
    assert f"animations   {clip.name}, again" in capsys.readouterr().out
