"""What changes from frame to frame: one record a character."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from footfall.arrays import Flags, Floats, Indices, Positions, Rotations, Seconds, Supports, Weights
from footfall.skeleton import BodyPart
from footfall.support import Support
from footfall.sync.tables import ABSENT

__all__ = [
    "EMPTY",
    "LEAVING",
    "RUNNING",
    "SEATS",
    "WAITING",
    "Character",
    "Frame",
    "Workspace",
    "character_type",
    "new_characters",
    "new_workspace",
]

SEATS = 8
"""How many actions a character can run, wait for and fade out of at the same time."""

PARTS = len(BodyPart)

EMPTY, WAITING, RUNNING, LEAVING = 0, 1, 2, 3
"""What `Character.status` says of a seat."""


class Character:
    """One row of a crowd, as the kernels see it: a record of `character_type`.

    "Seats" is `SEATS`; feet are in the order left, right.
    """

    clock: float
    """Clock time [s]."""

    root: Floats
    """Where the root is on the ground: x [m], z [m], heading [rad], shape (3,)."""

    ground_height: float
    """Height of the flat ground [m]."""

    synchronized: bool
    """Whether actions are synchronized, or play side by side."""

    printed: bool
    """Whether footprints are kept."""

    fresh: bool
    """Whether nothing has been shown yet: the first action then starts at full level."""

    support: int
    """What carries the body now."""

    starts: int
    """How many actions have been started, which orders them by age."""

    slot_index: int
    """How many slots have been entered."""

    slot_progress: float
    """Share of the slot that is over (the common phase of S-22)."""

    slot_duration: float
    """How long the slot lasts at the present weights; 0 where nothing is synchronized."""

    status: Indices
    """`EMPTY`, `WAITING`, `RUNNING` or `LEAVING`, shape (seats,)."""

    action: Indices
    """Which action of the library, shape (seats,)."""

    priorities: Floats
    """Priority on each body part, >= 0, shape (seats, parts)."""

    fade_asked: Seconds
    """How long the present fade should take [s], shape (seats,)."""

    fade_progress: Floats
    """How far it is, on the legs and on the rest of the body, shape (seats, 2)."""

    fade_elapsed: Seconds
    """How long it has taken so far, likewise [s]."""

    clip_time: Seconds
    """Where each clip is, past its end too [s], shape (seats,)."""

    rate: Floats
    """Clip time per clock time, shape (seats,)."""

    segment: Floats
    """The time warp of the slot: t0, h0, v0, t1, h1, v1, shape (seats, 6)."""

    target: Seconds
    """Clip time at the end of the slot, shape (seats,)."""

    natural: Seconds
    """What the slot would last at the clip's own speed [s], shape (seats,)."""

    posed_time: Seconds
    """Clip time of the pose shown last, shape (seats,)."""

    seat_points: Positions
    """Heel and toe of each foot in the pose shown last, relative to the clip's root, in leg
    lengths; the last seat is the neutral motion. Shape (seats + 1, 2, 2, 3)."""

    blended_points: Positions
    """The same after blending, relative to the root [m], shape (2, 2, 3)."""

    world_points: Positions
    """The same in the world, before footprints [m], shape (2, 2, 3)."""

    foot_offset: Positions
    """How far footprints move each foot [m], shape (2, 3)."""

    foot_velocity: Positions
    """How fast that changes [m/s], shape (2, 3)."""

    planted_time: Seconds
    """How long each foot has been carrying [s], 0 while it does not, shape (2,)."""

    pelvis_drop: Floats
    """How far the pelvis is lowered for a leg to reach [m], and how fast [m/s] (2,)."""

    weights: Weights
    """Weight on each body part; the last seat is the neutral motion. (seats + 1, parts)."""

    playing: Flags
    """The synchronizer's window, as `footfall.sync.Window`, whose arrays follow."""

    sequence: Indices
    priority: Floats
    age: Indices
    weight: Weights
    remaining: Seconds
    phases: Indices
    results: Supports
    spare_phases: Indices
    spare_results: Supports
    effectors: Floats
    """Blended pelvis height and ankle positions, shape (7,)."""

    ankles: Positions
    """Where the ankles should be, relative to the root [m], shape (2, 3)."""

    old_points: Positions
    """Foot points of the pose shown last, shape (seats + 1, 2, 2, 3)."""

    points: Positions
    """Heel and toe of the blended feet, relative to the root, in leg lengths, (2, 2, 3)."""

    heights: Floats
    """Their heights over where they rest, in leg lengths, shape (2, 2)."""

    toe_shares: Floats
    """Where between heel (0) and toe (1) each foot carries, shape (2,)."""

    slides: Floats
    """How far the motions themselves let each foot slide, x and z in leg lengths, (2, 2)."""

    offset: Positions
    """How far a footprint moves a foot, relative to the root [m], shape (3,)."""

    levels: Weights
    """Activation levels, shape (seats,)."""

    shares: Weights
    """Leg weights of those that vote on a duration, shape (seats,)."""

    votes: Seconds
    """Their votes [s], shape (seats,)."""


class Workspace(NamedTuple):
    """Memory in which one pose is worked out; one a thread."""

    turned: Rotations
    """Blended rotations, joints then feet, shape (joints + 2, 4)."""

    rotations: Rotations
    """Joints relative to the root, shape (joints, 4)."""

    positions: Positions
    """Joints relative to the root [m], shape (joints, 3)."""


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


def character_type(lookahead: int) -> np.dtype[Any]:
    """Return the memory layout of `Character`: one record, so that kernels pass one pointer."""
    return np.dtype(
        [
            ("clock", np.float64),
            ("root", np.float64, (3,)),
            ("ground_height", np.float64),
            ("synchronized", np.int8),
            ("printed", np.int8),
            ("fresh", np.int8),
            ("support", np.int64),
            ("starts", np.int64),
            ("slot_index", np.int64),
            ("slot_progress", np.float64),
            ("slot_duration", np.float64),
            ("status", np.int64, (SEATS,)),
            ("action", np.int64, (SEATS,)),
            (
                "priorities",
                np.float64,
                (
                    SEATS,
                    PARTS,
                ),
            ),
            ("fade_asked", np.float64, (SEATS,)),
            (
                "fade_progress",
                np.float64,
                (
                    SEATS,
                    2,
                ),
            ),
            (
                "fade_elapsed",
                np.float64,
                (
                    SEATS,
                    2,
                ),
            ),
            ("clip_time", np.float64, (SEATS,)),
            ("rate", np.float64, (SEATS,)),
            (
                "segment",
                np.float64,
                (
                    SEATS,
                    6,
                ),
            ),
            ("target", np.float64, (SEATS,)),
            ("natural", np.float64, (SEATS,)),
            ("posed_time", np.float64, (SEATS,)),
            (
                "seat_points",
                np.float64,
                (
                    SEATS + 1,
                    2,
                    2,
                    3,
                ),
            ),
            (
                "blended_points",
                np.float64,
                (
                    2,
                    2,
                    3,
                ),
            ),
            (
                "world_points",
                np.float64,
                (
                    2,
                    2,
                    3,
                ),
            ),
            (
                "foot_offset",
                np.float64,
                (
                    2,
                    3,
                ),
            ),
            (
                "foot_velocity",
                np.float64,
                (
                    2,
                    3,
                ),
            ),
            ("planted_time", np.float64, (2,)),
            ("pelvis_drop", np.float64, (2,)),
            (
                "weights",
                np.float64,
                (
                    SEATS + 1,
                    PARTS,
                ),
            ),
            ("playing", np.int8, (SEATS,)),
            ("sequence", np.int64, (SEATS,)),
            ("priority", np.float64, (SEATS,)),
            ("age", np.int64, (SEATS,)),
            ("weight", np.float64, (SEATS,)),
            ("remaining", np.float64, (SEATS,)),
            (
                "phases",
                np.int64,
                (
                    SEATS,
                    lookahead + 2,
                ),
            ),
            ("results", np.int64, (lookahead + 2,)),
            (
                "spare_phases",
                np.int64,
                (
                    SEATS,
                    lookahead + 2,
                ),
            ),
            ("spare_results", np.int64, (lookahead + 2,)),
            ("effectors", np.float64, (7,)),
            (
                "ankles",
                np.float64,
                (
                    2,
                    3,
                ),
            ),
            (
                "old_points",
                np.float64,
                (
                    SEATS + 1,
                    2,
                    2,
                    3,
                ),
            ),
            (
                "points",
                np.float64,
                (
                    2,
                    2,
                    3,
                ),
            ),
            (
                "heights",
                np.float64,
                (
                    2,
                    2,
                ),
            ),
            ("toe_shares", np.float64, (2,)),
            (
                "slides",
                np.float64,
                (
                    2,
                    2,
                ),
            ),
            ("offset", np.float64, (3,)),
            ("levels", np.float64, (SEATS,)),
            ("shares", np.float64, (SEATS,)),
            ("votes", np.float64, (SEATS,)),
        ],
        align=True,
    )


def new_characters(rows: int, lookahead: int) -> npt.NDArray[Any]:
    """Return characters that stand at the origin and play nothing, shape (rows,)."""
    characters = np.zeros(rows, dtype=character_type(lookahead))
    characters["synchronized"] = 1
    characters["printed"] = 1
    characters["fresh"] = 1
    characters["weights"][:, SEATS] = 1.0
    characters["phases"] = ABSENT
    characters["spare_phases"] = ABSENT
    for field in ("support", "results", "spare_results"):
        characters[field] = int(Support.DOUBLE)
    return characters


def new_workspace(joints: int) -> Workspace:
    """Return the memory in which one thread works out poses."""
    return Workspace(np.zeros((joints + 2, 4)), np.zeros((joints, 4)), np.zeros((joints, 3)))
