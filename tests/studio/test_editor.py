"""The support editor: undo, drafts that survive a crash, and annotations that are read back."""

from __future__ import annotations

from pathlib import Path

import pytest

from footfall.io import load_supports
from footfall.samples import sample
from footfall.studio.editor import DRAFTS, SupportEditor
from footfall.studio.work_folder import WorkFolder

WALK, SUPPORTS = sample("walk")


def editor(folder: Path) -> SupportEditor:
    return SupportEditor("walk", WALK, SUPPORTS, "walk.supports", WorkFolder.at(folder))


def test_a_drag_of_many_steps_is_one_edit(tmp_path: Path) -> None:
    mine = editor(tmp_path)
    for step in range(1, 6):
        mine.drag(0, 0, "end", 1.06 - 0.01 * step)
    mine.release()
    assert mine.bands.feet[0][0].end == pytest.approx(1.01)
    mine.undo()
    assert mine.bands == mine.saved
    assert not mine.can_undo
    mine.redo()
    assert mine.bands.feet[0][0].end == pytest.approx(1.01)


def test_unsaved_work_is_there_again_after_a_crash(tmp_path: Path) -> None:
    mine = editor(tmp_path)
    mine.edit(lambda bands: bands.without(1, 0))
    again = editor(tmp_path)
    assert again.restored
    assert again.bands.feet == mine.bands.feet
    again.undo()
    assert again.bands.feet == again.saved.feet
    assert not editor(tmp_path).restored


def test_saving_writes_what_is_read_back_and_forgets_the_draft(tmp_path: Path) -> None:
    mine = editor(tmp_path)
    mine.edit(lambda bands: bands.with_edge(0, 0, "start", 0.45))
    assert list((tmp_path / DRAFTS).iterdir())
    written = mine.save()
    assert load_supports(tmp_path / "walk.supports") == written
    assert not mine.changed
    assert list((tmp_path / DRAFTS).iterdir()) == []


@pytest.mark.parametrize("text", ["", "{", "[]", '{"duration": 1.0, "feet": [[], [{"x": 1}]]}'])
def test_a_broken_draft_is_left_alone(tmp_path: Path, text: str) -> None:
    (tmp_path / DRAFTS).mkdir()
    (tmp_path / DRAFTS / "walk.draft.json").write_text(text)
    assert not editor(tmp_path).restored


def test_thresholds_change_the_opinion_and_nothing_else(tmp_path: Path) -> None:
    mine = editor(tmp_path)
    before = mine.detected
    mine.set_thresholds(0.01, 0.2)
    assert mine.detected != before
    assert mine.bands == mine.saved
    mine.set_thresholds(None, None)
    assert mine.detected == before
    mine.adopt()
    assert mine.sequence.boundaries == pytest.approx(before.boundaries)
