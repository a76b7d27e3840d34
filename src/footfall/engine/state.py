"""What changes from frame to frame: one record a character."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Any, NamedTuple, cast, get_args, get_origin, get_type_hints

import numpy as np
import numpy.typing as npt

from footfall.arrays import Positions, Rotations, SmallFloats
from footfall.blending import Layers
from footfall.compilation import records
from footfall.engine.moment import Moment
from footfall.engine.record import COLUMNS, SEATS, Character
from footfall.octets import LANES
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import padded_count
from footfall.skeleton.octet_poses import PLACEMENT
from footfall.support import Support
from footfall.sync.search_memory import PlannerMemory, new_planner_memory
from footfall.sync.tables import ABSENT

__all__ = [
    "AIMS",
    "EMPTY",
    "GIVES_UP",
    "LEAVING",
    "RUNNING",
    "STARTS_MUTED",
    "WAITING",
    "Frame",
    "Workspace",
    "character_type",
    "moment_type",
    "new_characters",
    "new_workspace",
    "offset_of",
]

EMPTY, WAITING, RUNNING, LEAVING = 0, 1, 2, 3
"""What `Character.status` says of a seat."""


GIVES_UP, STARTS_MUTED = 0, 1
"""What `Character.late` says of a seat."""


AIMS = 17
"""Rows of `Workspace.aims`."""


class Workspace(NamedTuple):
    """Memory to work in; one a thread."""

    search: PlannerMemory
    """That of the planner."""

    kept: SmallFloats
    """Poses that are shown once more, shape (8, joints, 7)."""

    moments: npt.NDArray[Any]
    """What is worked out of the character at hand: one record of `moment_type`, shape (1,)."""

    points: SmallFloats
    """Heel and toe of each foot of one motion, in leg lengths, shape (2, 2, 3)."""

    layers: Layers
    """What is mixed into the pose of one character."""

    blended: SmallFloats
    """Blended poses of eight characters, by component, shape (8, 4 rows + 8)."""

    local: SmallFloats
    """Their rotations, the eight side by side, shape (4, rows, 8)."""

    aims: SmallFloats
    """What their bodies have to reach, shape (aims, 8): see `footfall.engine.placing`."""


class Frame(NamedTuple):
    """One character at one instant: a view that the next advance overwrites."""

    clock: float
    """Clock time [s]."""

    support: Support
    """What carries the body."""

    world_positions: Positions
    """Joints in the world [m], shape (joints, 3)."""

    world_rotations: Rotations
    """Joints in the world, shape (joints, 4)."""


@lru_cache
def character_type(lookahead: int) -> np.dtype[Any]:
    """Return the memory layout of `Character`: one record, so that kernels pass one pointer.

    Always the same object: two alike are compared field by field in every call of a kernel.

    Args:
        lookahead: How many slots ahead are decided.
    """
    return _memory_layout(Character, lookahead)


def offset_of(field: str) -> int:
    """Return how many bytes of a character come before a field, whatever the look-ahead."""
    layout: Any = character_type(1)
    return int(layout.fields[field][1])


def _memory_layout(kind: type, lookahead: int) -> np.dtype[Any]:
    numbers = {int: np.int64, float: np.float64, bool: np.int8}
    fields: list[tuple[Any, ...]] = []
    for name, hint in get_type_hints(kind, include_extras=True).items():
        if get_origin(hint) is not Annotated:
            fields.append((name, numbers[hint]))
            continue
        array, *shape = get_args(hint)
        if array is int:
            fields.append((name, shape[0]))
            continue
        if isinstance(shape[0], np.dtype):
            fields.append((name, cast(Any, shape[0]), tuple(shape[1:])))
            continue
        # The last argument of an array type is its numbers' type; before NumPy 2.5, its dtype.
        number = get_args(array)[-1]
        number = (get_args(number) or (number,))[0]
        number = np.int8 if number is np.bool_ else number
        fields.append((name, number, tuple(lookahead + 2 if n == COLUMNS else n for n in shape)))
    return np.dtype(fields, align=True)


moment_type = _memory_layout(Moment, 0)
"""The memory layout of `Moment`."""


def new_characters(rows: int, lookahead: int) -> npt.NDArray[Any]:
    """Return characters that stand at the origin and play nothing, shape (rows,)."""
    characters = records(np.zeros(rows, dtype=character_type(lookahead)))
    characters["synchronized"] = 1
    characters["printed"] = 1
    characters["present"] = 1
    characters["fresh"] = 1
    characters["placed"] = 1
    characters["weights"][:, SEATS] = 1.0
    characters["phases"] = ABSENT
    for field in ("support", "results"):
        characters[field] = int(Support.DOUBLE)
    return characters


def new_workspace(joints: int, lookahead: int = 1) -> Workspace:
    """Return the memory in which one thread works.

    Args:
        joints: How many joints the bodies have.
        lookahead: How many slots ahead are decided.
    """
    rows, layers = padded_count(joints), SEATS + 1
    moments = records(np.zeros(1, dtype=moment_type))
    moments["step"] = -1.0
    return Workspace(
        new_planner_memory(SEATS, lookahead),
        np.zeros((LANES, joints, PLACEMENT), dtype=np.float32),
        moments,
        np.zeros((2, 2, 3), dtype=np.float32),
        Layers(
            np.zeros(layers, dtype=np.int64),
            np.zeros(layers, dtype=np.int64),
            np.zeros(layers, dtype=np.float32),
            np.zeros((layers, len(BodyPart)), dtype=np.float32),
            np.zeros(layers, dtype=np.bool_),
        ),
        np.zeros((LANES, 4 * rows + LANES), dtype=np.float32),
        np.zeros((4, rows, LANES), dtype=np.float32),
        np.zeros((AIMS, LANES), dtype=np.float32),
    )
