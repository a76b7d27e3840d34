"""What a character remembers from frame to frame, and what a kernel works on: one record."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from footfall.arrays import (
    Counts,
    Flags,
    Floats,
    Seconds,
    SmallFloats,
    SmallIndices,
    Supports,
)
from footfall.engine.feet_record import Feet
from footfall.engine.layer_record import LAYERS, LayerSeats, layer_seat_type
from footfall.skeleton import BodyPart

__all__ = ["COLUMNS", "FULL", "HALF_RATE", "NO_REACHING", "SEATS", "Character"]

SEATS = 8
"""How many actions a character can run, wait for and fade out of at the same time."""

PARTS = len(BodyPart)

FULL, NO_REACHING, HALF_RATE = 0, 1, 2
"""Values of `Character.detail`: everything; no legs that reach; every second frame only."""

COLUMNS = -1
"""Stands for the columns of the window, look-ahead + 2."""


class Character(Feet):
    """One row of a crowd, as the kernels see it: a record of `character_type`.

    "Seats" is `SEATS`; feet are in the order left, right.
    """

    clock: float
    """Clock time [s]."""

    root: Annotated[Floats, 3]
    """Where the root is on the ground: x [m], z [m], heading [rad], shape (3,)."""

    facing: Annotated[Floats, 2]
    """Cosine and sine of that heading in the pose shown last, shape (2,)."""

    level: Annotated[Floats, 2]
    """Height of the root's own level, on which the blended pose stands [m], and how fast it
    changes [m/s], shape (2,)."""

    synchronized: bool
    """Whether actions are synchronized, or play side by side."""

    printed: bool
    """Whether footprints are kept."""

    fresh: bool
    """Whether nothing has been shown yet: the first action then starts at full level."""

    placed: bool
    """Whether it was put somewhere since the pose shown last: there are no footprints then."""

    steered: bool
    """Whether the root turns as `steer` says, whatever the motions do."""

    twisted: bool
    """Whether a foot is turned against its motion, or is going to be."""

    layered: bool
    """Whether anything is laid over what plays."""

    stands: bool
    """Whether the neutral motion has weight on the legs."""

    flight: Annotated[int, np.int8]
    """What happens while nothing carries: a number of `footfall.engine.flight.FLIGHTS`."""

    aloft: bool
    """Whether the body falls freely."""

    pelvis: Annotated[Floats, 2]
    """Height of the pelvis in the blended pose [m], and how fast it goes up while it falls freely
    [m/s], shape (2,)."""

    lift: Annotated[Floats, 2]
    """How far free fall has taken it from there [m], and how fast that changes [m/s], (2,)."""
    present: bool
    """Whether there is anybody in this row."""

    detail: Annotated[int, np.int8]
    """How much is worked out: `FULL`, `NO_REACHING` or `HALF_RATE`."""

    rests: bool
    """Whether a row at half rate has left this frame out."""

    owed: float
    """Time that it has left out [s]."""

    support: int
    """What carries the body now."""

    occupied: int
    """How many seats come before the last one that is taken, that one included."""

    starts: Annotated[int, np.int32]
    """How many actions have been started, which orders them by age."""

    slot_index: Annotated[int, np.int32]
    """How many slots have been entered."""

    slot_progress: float
    """Share of the slot that is over (the common phase of S-22)."""

    slot_duration: float
    """How long the slot lasts at the present weights; 0 where nothing is synchronized."""

    unsettled: bool
    """Whether a stop or a change of priority calls for a new plan."""

    changing: bool
    """Whether a priority is on its way to another one."""

    status: Annotated[SmallIndices, SEATS]
    """`EMPTY`, `WAITING`, `RUNNING` or `LEAVING`, shape (seats,)."""

    action: Annotated[SmallIndices, SEATS]
    """Which action of the library, shape (seats,)."""

    clip_time: Annotated[Seconds, SEATS]
    """Where each clip is, past its end too [s], shape (seats,)."""

    rate: Annotated[Floats, SEATS]
    """Clip time per clock time, shape (seats,)."""

    posed_time: Annotated[Seconds, SEATS]
    """Clip time of the pose shown last, shape (seats,)."""

    blended_points: Annotated[Floats, 2, 2, 2]
    """Heel and toe of the blended feet in the pose shown last, x and z relative to the root, in leg
    lengths, shape (2, 2, 2)."""

    alone_time: float
    """How long the present foot has been carrying alone [s], 0 while both do, or none."""

    pelvis_drop: Annotated[SmallFloats, 2]
    """How far the pelvis is lowered for a leg to reach [m], and how fast [m/s] (2,)."""

    weights: Annotated[SmallFloats, SEATS + 1, PARTS]
    """Weight on each body part; the last seat is the neutral motion. (seats + 1, parts)."""

    span: Annotated[Seconds, 2]
    """Clock time at which the time warps of the slot begin and end [s], shape (2,)."""

    segment: Annotated[Floats, SEATS, 3]
    """The time warp of each action: clip time and rate at the beginning of `span`, and the rate at
    its end, shape (seats, 3)."""

    target: Annotated[Seconds, SEATS]
    """Clip time there, at the end of the slot, shape (seats,)."""

    fade_progress: Annotated[Floats, SEATS, 2]
    """How far it is, on the legs and on the rest of the body, shape (seats, 2)."""

    presence: Annotated[SmallFloats, SEATS]
    """How much of its leg weight a muted action keeps, on its way to 0, and of another one on
    its way to 1, shape (seats,)."""

    playing: Annotated[Flags, SEATS]
    """The synchronizer's window, as `footfall.sync.Window`, whose arrays follow."""
    muted: Annotated[Flags, SEATS]
    results: Annotated[Supports, COLUMNS]
    priority: Annotated[SmallFloats, SEATS]
    age: Annotated[Counts, SEATS]
    weight: Annotated[SmallFloats, SEATS]
    remaining: Annotated[Seconds, SEATS]
    phases: Annotated[Counts, SEATS, COLUMNS]
    held: Annotated[Counts, SEATS]
    durations: Annotated[Seconds, COLUMNS]
    pace: Annotated[Floats, SEATS, 2]
    slot_offset: Annotated[Seconds, 1]
    steady: Annotated[Seconds, 1]

    priorities_asked: Annotated[SmallFloats, SEATS, PARTS]
    """Priority on each body part, or what it becomes, >= 0, shape (seats, parts)."""

    priorities_before: Annotated[SmallFloats, SEATS, PARTS]
    """What it was when that was asked for, shape (seats, parts)."""

    priority_progress: Annotated[SmallFloats, SEATS, PARTS]
    """How far it has come, 0 to 1, shape (seats, parts)."""

    priority_elapsed: Annotated[SmallFloats, SEATS]
    """How long that has taken so far on the legs, where it may have to wait [s], shape (seats,)."""

    priority_seconds: Annotated[SmallFloats, SEATS]
    """How long it should take [s], > 0, shape (seats,)."""

    share_speed_before: Annotated[SmallFloats, SEATS, PARTS]
    """How fast the share went, per progress, when that was asked for, shape (seats, parts)."""

    patience: Annotated[Seconds, SEATS]
    """Clock time until which a start waits [s], shape (seats,)."""

    late: Annotated[SmallIndices, SEATS]
    """What becomes of it then: `GIVES_UP` or `STARTS_MUTED`, shape (seats,)."""

    natural: Annotated[Seconds, SEATS]
    """What the slot would last at the clip's own speed [s], shape (seats,)."""

    fade_asked: Annotated[SmallFloats, SEATS]
    """How long the present fade should take [s], shape (seats,)."""

    fade_elapsed: Annotated[Seconds, SEATS]
    """How long it has taken so far on the legs, where it may have to wait [s], shape (seats,)."""

    levels: Annotated[SmallFloats, SEATS]
    """Activation levels of the body part at hand, shape (seats,)."""

    taken: Annotated[SmallFloats, SEATS]
    """The same, where a priority is on its way from 0 or to 0, shape (seats,)."""

    priorities_now: Annotated[SmallFloats, SEATS, 1]
    """Priorities on the body part at hand, shape (seats, 1)."""

    share_speed: Annotated[SmallFloats, SEATS]
    """How fast the shares of it go, per progress, shape (seats,)."""

    steer: float
    """How fast the root turns to the left where it is steered [rad/s]."""

    foot_turn: Annotated[Floats, 2, 2]
    """How far each foot is turned to the left against its motion, for it stays as it was planted
    while the root is steered [rad], and how fast that changes [rad/s], shape (2, 2)."""

    layers: Annotated[LayerSeats, layer_seat_type, LAYERS]
    """What is laid over what plays: records of `LayerSeat`, shape (layers,)."""
