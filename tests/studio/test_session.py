"""One session for all tabs: what is looked at, what is edited, what is taken in."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.studio.sessions import session_of

from footfall.errors import ArgumentError
from footfall.io import load_supports
from footfall.scenario.cue_sheet import ActionEntry
from footfall.studio.jobs import Job


def test_an_unknown_view_is_refused_and_the_old_one_stays(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    with pytest.raises(ArgumentError) as caught:
        session.show("moon")
    assert str(caught.value) == "no view 'moon'; there are: stage, supports, crowd"
    assert session.view == "stage"


def test_the_supports_of_the_first_single_motion_are_looked_at(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path)
    gait = ActionEntry("go", "sample:walk", others=("sample:run",))
    session.take_in(session.motions.resolve_entry(gait))
    session.show("supports")
    assert session.editor is None
    with pytest.raises(ArgumentError) as caught:
        session.select("go")
    assert str(caught.value) == "'go' is a gait of several motions; edit those"
    session.take_in(session.motions.resolve("sample:run"))
    session.show("supports")
    assert session.editor is not None
    assert session.editor.name == "run"
    with pytest.raises(ArgumentError) as caught:
        session.select("fly")
    assert str(caught.value) == "no motion 'fly' to edit"


def test_saved_supports_are_performed_and_told(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    session.select("walk")
    assert session.editor is not None
    end = session.editor.bands.feet[0][0].end
    session.editor.drag(0, 0, "end", end - 0.05)
    session.editor.release()
    session.save_supports()
    saved = load_supports(tmp_path / "walk.supports")
    assert session.motions.motions[0].motion.supports == saved
    assert session.stage.motions[0].supports == saved
    assert ("info", "saved walk.supports") in heard.notices()


def test_unsaved_work_is_back_after_a_crash(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    session.select("walk")
    assert session.editor is not None
    session.editor.drag(0, 0, "end", session.editor.bands.feet[0][0].end - 0.05)
    session.editor.release()
    moved = session.editor.bands.feet[0][0].end
    again, heard = session_of(tmp_path, "walk")
    again.select("walk")
    assert again.editor is not None
    assert again.editor.bands.feet[0][0].end == pytest.approx(moved)
    assert heard.notices() == [("info", "walk: unsaved work is back")]


def test_a_motion_taken_in_anew_begins_a_new_take_and_another_one_does_not(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    session.take_in(session.motions.resolve("sample:run"))
    assert session.stage.begun
    session.take_in(session.motions.resolve("sample:walk"))
    assert not session.stage.begun
    assert [one.name for one in session.motions.motions] == ["walk", "run"]


def test_a_removed_motion_is_gone_from_stage_and_editor(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk", "run")
    session.select("run")
    session.remove("run")
    assert session.editor is None
    assert [card.name for card in session.stage.cards] == ["walk"]
    assert "changed" in heard.kinds()
    session.remove("walk")
    assert session.stage.cards == []
    assert session.stage.performer is None


def test_a_crowd_is_gathered_beside_and_walks_at_once(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    gait = ActionEntry("go", "sample:walk-slow", others=("sample:run",))
    session.take_in(session.motions.resolve_entry(gait))
    session.crowd_size = 25
    session.show("crowd")
    session.jobs.wait()
    assert session.crowd is not None
    assert (session.crowd.size, session.crowd.names) == (25, ("walk", "go"))
    assert session.crowd_json() in heard.messages
    for _ in range(30):
        session.crowd.advance()
    session.crowd.start("go", 0)
    for _ in range(60):
        session.crowd.advance()
    shares = session.crowd.table(session.crowd.shares())
    # Both have the same priority.
    assert shares[0][1:] == pytest.approx([0.5, 0.5], abs=0.01)
    assert shares[4][1] > 0.9


def test_without_a_scene_there_is_no_picture(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    with pytest.raises(RuntimeError, match="no 3D scene is open"):
        session.picture(10, 10)
    session.camera = lambda width, height: (width, height)
    assert session.picture(3, 4) == (3, 4)


def test_work_that_is_not_over_is_told(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path)
    seen: list[object] = []

    def work(job: Job) -> None:
        job.report(0.25, "deep")
        seen.append(session.jobs_json())

    session.jobs.begin("digging", work)
    session.jobs.wait()
    job = {"number": 1, "title": "digging", "share": 0.25, "detail": "deep", "canceled": False}
    assert seen == [{"kind": "jobs", "jobs": [job]}]
    assert session.jobs_json() == {"kind": "jobs", "jobs": []}
