"""Motions are loaded beside the live session, and nothing that is wrong with one stops it."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.studio.sessions import session_of

from footfall.errors import ArgumentError, FileFormatError, ScenarioError
from footfall.io import save
from footfall.samples import sample
from footfall.studio import work_folder
from footfall.studio.gaits import GAIT_SAMPLES, load_gait, load_own_gait
from footfall.studio.loading import load, load_from_page, set_option
from footfall.studio.motion_list import LoadedMotion


def test_a_motion_that_cannot_be_read_is_told_and_the_others_are_loaded(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path)
    (tmp_path / "broken.bvh").write_text("HIERARCHY")
    load(session, ["sample:walk", "broken.bvh", "sample:nothing", "sample:run"])
    session.jobs.wait()
    assert [one.name for one in session.motions.motions] == ["walk", "run"]
    errors = [text for level, text in heard.notices() if level == "error"]
    assert len(errors) == 2
    assert "broken.bvh" in errors[0]
    assert "no sample named 'nothing'" in errors[1]


def test_progress_names_each_motion_and_reaches_the_end(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path)
    load(session, ["sample:walk", "sample:run"])
    session.jobs.wait()
    jobs = [one["jobs"][0] for one in heard.messages if one["kind"] == "jobs" and one["jobs"]]
    shares = [job["share"] for job in jobs]
    assert shares == sorted(shares)
    assert {0.5, 1.0} <= set(shares)
    assert {job["title"] for job in jobs} == {"loading 2 motions"}
    assert {"sample:walk", "sample:run"} <= {job["detail"] for job in jobs}


def test_loading_that_is_canceled_keeps_what_has_been_loaded(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path)
    hear = session.tell

    def cancel_at_the_second(message: dict[str, object]) -> None:
        hear(message)
        for job in session.jobs.present:
            if job.detail == "sample:run":
                job.cancel()

    session.tell = cancel_at_the_second
    load(session, ["sample:walk", "sample:run", "sample:kick"])
    session.jobs.wait()
    assert [one.name for one in session.motions.motions] == ["walk"]
    assert heard.notices() == [("error", "canceled: loading 3 motions")]
    assert session.jobs.present == ()


def test_a_motion_loaded_while_it_walks_lets_it_walk_on(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    for _ in range(30):
        session.stage.advance()
    load(session, ["sample:run"])
    session.jobs.wait()
    assert session.stage.pair()[0].frame == 30
    assert [card.name for card in session.stage.cards] == ["walk", "run"]


def test_a_page_loads_from_the_folder_only_and_nothing_huge(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session, _ = session_of(tmp_path)
    with pytest.raises(FileFormatError, match="lies outside of"):
        load_from_page(session, "/etc/passwd")
    monkeypatch.setattr(work_folder, "LARGEST_FILE", 100)
    (tmp_path / "huge.bvh").write_bytes(b"x" * 101)
    with pytest.raises(FileFormatError, match="the studio reads files up to"):
        load_from_page(session, "huge.bvh")
    load_from_page(session, "sample:walk")
    session.jobs.wait()
    assert [one.name for one in session.motions.motions] == ["walk"]


def test_an_option_reads_a_motion_again(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    first = session.motions.motions[0].motion
    set_option(session, "walk", "mirror", True)
    session.jobs.wait()
    loaded = session.motions.motions[0]
    assert loaded.entry.mirror
    assert str(loaded.motion.supports)[0] == {"R": "L", "L": "R"}[str(first.supports)[0]]
    assert len(session.motions.motions) == 1
    for name, option in (("walk", "sing"), ("run", "mirror")):
        with pytest.raises(ArgumentError) as caught:
            set_option(session, name, option, True)
        told = f"no option {option!r} of {name!r}; cyclic, clean, mirror are"
        assert str(caught.value) == told


def test_an_option_that_fails_leaves_the_motion_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session, heard = session_of(tmp_path, "walk")
    before = session.motions.motions[0]

    def reload(name: str, **changes: object) -> LoadedMotion:
        raise ScenarioError(f"{name} cannot be read with {changes}")

    monkeypatch.setattr(session.motions, "reload", reload)
    set_option(session, "walk", "clean", True)
    session.jobs.wait()
    assert heard.notices() == [
        ("error", "walk cannot be read with {'clean': True, 'supports': None}")
    ]
    assert session.motions.motions == [before]


def test_a_gait_is_made_of_the_walks_and_runs_that_are_loaded(tmp_path: Path) -> None:
    session, heard = session_of(
        tmp_path, "kick", "walk", "idle", "run", "side-step", "walk-backward", "walk-left"
    )
    load_own_gait(session)
    session.jobs.wait()
    assert [text for level, text in heard.notices() if level == "error"] == []
    gait = session.motions.find("go")
    assert gait is not None
    assert (gait.entry.motion, *gait.entry.others) == (
        "sample:walk",
        "sample:run",
        "sample:walk-left",
    )
    load_own_gait(session)
    session.jobs.wait()
    assert session.motions.find("go 2") is not None


def test_a_gait_of_files_is_loaded_and_goes(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path)
    for name in ("walk", "run"):
        save(sample(name)[0], tmp_path / f"my {name}.bvh")
    save(sample("walk")[0], tmp_path / "as fast.bvh")
    load(session, ["my walk.bvh", "as fast.bvh", "my run.bvh"])
    session.jobs.wait()
    load_own_gait(session)
    session.jobs.wait()
    assert [text for level, text in heard.notices() if level == "error"] == []
    gait = session.motions.find("go")
    assert gait is not None
    # Of two that go as fast the second one adds nothing.
    assert (gait.entry.motion, gait.entry.others) == ("my walk.bvh", ("my run.bvh",))
    session.stage.start(session.stage.cards[3])
    for _ in range(60):
        session.stage.advance()
    assert session.stage.activity()["go"] == "running"


def test_too_few_walks_are_told(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    with pytest.raises(ArgumentError) as caught:
        load_own_gait(session)
    assert str(caught.value) == "a gait is made of two or more walks and runs; load them first"
    session.take_in(session.motions.resolve("sample:kick"))
    load_own_gait(session)
    session.jobs.wait()
    assert [text for level, text in heard.notices() if level == "error"] == [
        "1 of the 2 motions is a walk or a run that can be steered; two that go at different "
        "speeds or turns are needed"
    ]


def test_the_gait_of_samples_is_loaded_by_name(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    load_gait(session, "go", GAIT_SAMPLES)
    session.jobs.wait()
    spans = session.stage.pair()[0].reach("go")
    assert spans is not None
    assert [round(value, 2) for span in spans for value in span] == [0.75, 3.3, -0.65, 0.65]
