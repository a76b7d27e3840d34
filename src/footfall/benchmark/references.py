"""The reference work, and how much faster blocks are than other ways to do it."""

from __future__ import annotations

import numpy as np

from footfall.benchmark.reference_rivals import work_in_numpy, work_one_by_one
from footfall.benchmark.reference_work import new_task, work_in_blocks
from footfall.benchmark.rows import Row, seconds_each

__all__ = ["reference_rows"]

ROWS = 1000


def reference_rows() -> list[Row]:
    """Measure the reference work for 1 000 characters on one thread."""
    task = new_task(ROWS)
    joints, count = len(task.rig.parents), task.rig.part_masks.shape[1]
    local, rotations = np.zeros((count, 4)), np.zeros((ROWS, joints, 4))
    positions = np.zeros((ROWS, joints, 3))
    ours = seconds_each(lambda: work_in_blocks(task), 15, 10) / ROWS
    single = seconds_each(lambda: work_one_by_one(task, local, rotations, positions), 7, 3) / ROWS
    plain = seconds_each(lambda: work_in_numpy(task), 5) / ROWS
    return [
        Row("reference_1k_us", 1e6 * ours, 0.30, "us a character"),
        Row("per_character_ratio", single / ours, None, "times the blocks' time"),
        Row("numpy_ratio", plain / ours, None, "times the blocks' time"),
    ]
