"""Where a character would come to rest if it stopped now: tried out on a copy of its record."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.compilation import records
from footfall.engine.commands import stop_rows
from footfall.engine.crowd import Crowd
from footfall.engine.pipeline import LONGEST_STEP, advance_blocks
from footfall.octets import LANES
from footfall.skeleton.octet_poses import PLACEMENT

__all__ = ["stopping_place"]

LONGEST = 3.0
"""How long a stop may take [s]."""


def stopping_place(crowd: Crowd, row: int, actions: Sequence[int]) -> tuple[float, float]:
    """Return where the root of a character would come to rest, x and z [m]; nothing is changed.

    Args:
        crowd: The crowd.
        row: Which of its characters.
        actions: What would be stopped.
    """
    tried = records(crowd.characters[[row]].copy())
    tried["steer"] = 0.0
    shelf, rig, workspace = crowd.kernel_body_of(row)
    ground = crowd.packed_ground_of(row)
    poses = np.zeros((1, rig.parents.shape[0], PLACEMENT, LANES), dtype=np.float32)
    for action in actions:
        stop_rows(shelf, tried, np.zeros(1, dtype=np.int64), action)
    for _ in range(round(LONGEST / LONGEST_STEP)):
        if not np.isin(tried["action"][tried["status"] != 0], actions).any():
            break
        advance_blocks(
            shelf,
            ground,
            rig,
            tried,
            workspace,
            crowd.rules,
            poses,
            LONGEST_STEP,
            0,
            1,
        )
    x, z, _ = tried["root"][0].tolist()
    return x, z
