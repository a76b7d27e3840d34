from __future__ import annotations

import numpy as np
import pytest

from footfall.benchmark.reference_rivals import work_in_numpy, work_one_by_one
from footfall.benchmark.reference_work import new_task, placed_joints, work_in_blocks

ROWS = 64


def test_blocks_do_what_is_done_one_by_one() -> None:
    task = new_task(ROWS)
    work_in_blocks(task)
    joints, count = len(task.rig.parents), task.rig.part_masks.shape[1]
    rotations, positions = np.zeros((ROWS, joints, 4)), np.zeros((ROWS, joints, 3))
    work_one_by_one(task, np.zeros((count, 4)), rotations, positions)
    assert placed_joints(task) == pytest.approx(positions, abs=2e-4)
    blocked = task.poses[:, :, :4].transpose(0, 3, 1, 2).reshape(ROWS, joints, 4)
    assert np.abs((blocked * rotations).sum(axis=-1)) == pytest.approx(1.0, abs=1e-5)


def test_numpy_places_all_but_the_legs_likewise() -> None:
    task = new_task(ROWS)
    work_in_blocks(task)
    trunk = task.rig.leg_sides < 0
    plain = work_in_numpy(task)[:, trunk]
    assert plain == pytest.approx(placed_joints(task)[:, trunk], abs=1e-5)
