"""A crowd is started and stopped in groups, and stays on its field."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.studio.crowd_stage import GROUP_NAMES, CrowdStage
from footfall.studio.motion_list import MotionList
from footfall.studio.work_folder import WorkFolder


@pytest.fixture
def crowd(tmp_path: Path) -> CrowdStage:
    motions = MotionList(WorkFolder.at(tmp_path))
    for name in ("walk", "run"):
        motions.keep(motions.resolve(f"sample:{name}"))
    entries = [one.entry for one in motions.motions]
    return CrowdStage(entries, tuple(one.motion for one in motions.motions), 40)


def test_a_group_starts_and_stops_and_the_others_do_not(crowd: CrowdStage) -> None:
    crowd.start("walk", 1)
    for _ in range(60):
        crowd.advance()
    shares = crowd.shares()
    assert shares.sum(axis=1) == pytest.approx(1.0)
    walks = shares[:, 1] > 0.9
    np.testing.assert_array_equal(walks, crowd.group == 1)
    assert [row[1] for row in crowd.table(shares)] == pytest.approx([0, 1, 0, 0, 0], abs=0.01)
    crowd.stop("walk", 1)
    for _ in range(60):
        crowd.advance()
    assert crowd.shares()[:, 0] == pytest.approx(1.0)


def test_a_start_that_was_stopped_at_once_never_comes(crowd: CrowdStage) -> None:
    crowd.start("run", 0)
    crowd.stop("run", 0)
    for _ in range(40):
        crowd.advance()
    assert crowd.shares()[:, 0] == pytest.approx(1.0)


def test_who_leaves_the_field_enters_on_the_other_side(crowd: CrowdStage) -> None:
    for group in range(len(GROUP_NAMES)):
        crowd.start("run", group)
    for _ in range(300):
        crowd.advance()
    assert np.abs(crowd.positions[:, 0, 2]).max() > 0.5 * crowd.width
    shown = (crowd.positions[:, 0] + crowd.shifts())[:, [0, 2]]
    assert np.abs(shown).max() <= 0.5 * crowd.width + 1e-9
