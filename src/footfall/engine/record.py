"""What a character remembers from frame to frame, and what a kernel works on: one record."""

from __future__ import annotations

from typing import Annotated

from footfall.arrays import Flags, Floats, Indices, Positions, Seconds, Supports, Weights
from footfall.skeleton import BodyPart

__all__ = ["COLUMNS", "FULL", "HALF_RATE", "NO_REACHING", "SEATS", "Character"]

SEATS = 8
"""How many actions a character can run, wait for and fade out of at the same time."""

PARTS = len(BodyPart)

FULL, NO_REACHING, HALF_RATE = 0, 1, 2
"""Values of `Character.detail`: everything; no legs that reach; every second frame only."""

COLUMNS = -1
"""Stands for the columns of the window, look-ahead + 2."""


class Character:
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

    foot_ground: Annotated[Floats, 2, 2]
    """Height of the ground under heel and toe of each foot [m], shape (2, 2)."""

    foot_slope: Annotated[Floats, 2, 2]
    """How the sole of each foot is tilted: rise per meter along the world's x and z, (2, 2)."""

    tilt: Annotated[Floats, 2, 2]
    """The tilt of each sole in the pose shown last, likewise, shape (2, 2)."""

    tilt_rise: Annotated[Floats, 2, 2]
    """How far that raises heel and toe [m], shape (2, 2)."""

    ground_slope: Annotated[Floats, 2, 2]
    """How the ground under each foot is tilted, likewise, shape (2, 2)."""

    ground_below: Annotated[Floats, 2]
    """Height of the ground under the middle of each sole [m], shape (2,)."""

    surface: Annotated[Indices, 2]
    """The surface that each carrying foot is on, else -1, shape (2,)."""

    carried: Annotated[Positions, 2, 3]
    """How far the surfaces under the feet have taken them since the beginning [m], (2, 3)."""

    toe_velocity: Annotated[Floats, 2, 2]
    """How fast the blended toes go over the ground, x and z [m/s], shape (2, 2)."""

    synchronized: bool
    """Whether actions are synchronized, or play side by side."""

    printed: bool
    """Whether footprints are kept."""

    fresh: bool
    """Whether nothing has been shown yet: the first action then starts at full level."""

    placed: bool
    """Whether it was put somewhere since the pose shown last: there are no footprints then."""

    present: bool
    """Whether there is anybody in this row."""

    detail: int
    """How much is worked out: `FULL`, `NO_REACHING` or `HALF_RATE`."""

    rests: bool
    """Whether a row at half rate has left this frame out."""

    owed: float
    """Time that it has left out [s]."""

    support: int
    """What carries the body now."""

    occupied: int
    """How many seats come before the last one that is taken, that one included."""

    starts: int
    """How many actions have been started, which orders them by age."""

    slot_index: int
    """How many slots have been entered."""

    slot_progress: float
    """Share of the slot that is over (the common phase of S-22)."""

    slot_duration: float
    """How long the slot lasts at the present weights; 0 where nothing is synchronized."""

    unsettled: bool
    """Whether a stop or a change of priority calls for a new plan."""

    status: Annotated[Indices, SEATS]
    """`EMPTY`, `WAITING`, `RUNNING` or `LEAVING`, shape (seats,)."""

    action: Annotated[Indices, SEATS]
    """Which action of the library, shape (seats,)."""

    clip_time: Annotated[Seconds, SEATS]
    """Where each clip is, past its end too [s], shape (seats,)."""

    rate: Annotated[Floats, SEATS]
    """Clip time per clock time, shape (seats,)."""

    posed_time: Annotated[Seconds, SEATS]
    """Clip time of the pose shown last, shape (seats,)."""

    seat_points: Annotated[Positions, SEATS, 2, 2, 3]
    """Heel and toe of each foot in the pose shown last, relative to the clip's root, in leg
    lengths, shape (seats, 2, 2, 3)."""

    blended_points: Annotated[Positions, 2, 2, 3]
    """The same after blending, relative to the root [m], shape (2, 2, 3)."""

    world_points: Annotated[Positions, 2, 2, 3]
    """The same in the world, before footprints [m], shape (2, 2, 3)."""

    foot_offset: Annotated[Positions, 2, 3]
    """How far footprints move each foot [m], shape (2, 3)."""

    foot_velocity: Annotated[Positions, 2, 3]
    """How fast that changes [m/s], shape (2, 3)."""

    stands: bool
    """Whether the neutral motion has weight on the legs."""

    stance: Annotated[Floats, 2, 2]
    """How far each foot then stands from where the neutral pose has it, x and z in leg lengths,
    shape (2, 2)."""

    shown_ankles: Annotated[Floats, 2, 2]
    """Where the ankles were shown last, footprints included, x and z relative to the root in leg
    lengths, shape (2, 2)."""

    alone_time: float
    """How long the present foot has been carrying alone [s], 0 while both do, or none."""

    planted_time: Annotated[Seconds, 2]
    """How long each foot has been carrying [s], 0 while it does not, shape (2,)."""

    pelvis_drop: Annotated[Floats, 2]
    """How far the pelvis is lowered for a leg to reach [m], and how fast [m/s] (2,)."""

    weights: Annotated[Weights, SEATS + 1, PARTS]
    """Weight on each body part; the last seat is the neutral motion. (seats + 1, parts)."""

    effectors: Annotated[Floats, 7]
    """Blended pelvis height and ankle positions, shape (7,)."""

    way: Annotated[Floats, 3]
    """Where the motions take the root in this step: x, z in leg lengths, heading [rad], (3,)."""

    points: Annotated[Positions, 2, 2, 3]
    """Heel and toe of the blended feet, relative to the root, in leg lengths, (2, 2, 3)."""

    heights: Annotated[Floats, 2, 2]
    """Their heights over where they rest, in leg lengths, shape (2, 2)."""

    toe_shares: Annotated[Floats, 2]
    """Where between heel (0) and toe (1) each foot carries, on its way to `on_toes`, (2,)."""

    slides: Annotated[Floats, 2, 2, 2]
    """How far the motions themselves let heel and toe of each foot slide, x and z in leg lengths,
    shape (2, 2, 2)."""

    slide_speeds: Annotated[Floats, 2, 2]
    """How fast, smoothed [m/s], shape (2, 2)."""

    on_toes: Annotated[Flags, 2]
    """Whether the toe of each foot carries rather than its heel, shape (2,)."""

    segment: Annotated[Floats, SEATS, 6]
    """The time warp of the slot: t0, h0, v0, t1, h1, v1, shape (seats, 6)."""

    fade_progress: Annotated[Floats, SEATS, 2]
    """How far it is, on the legs and on the rest of the body, shape (seats, 2)."""

    presence: Annotated[Floats, SEATS]
    """How much of its leg weight a muted action keeps, on its way to 0, and of another one on
    its way to 1, shape (seats,)."""

    playing: Annotated[Flags, SEATS]
    """The synchronizer's window, as `footfall.sync.Window`, whose arrays follow."""
    muted: Annotated[Flags, SEATS]
    results: Annotated[Supports, COLUMNS]
    sequence: Annotated[Indices, SEATS]
    priority: Annotated[Floats, SEATS]
    age: Annotated[Indices, SEATS]
    weight: Annotated[Weights, SEATS]
    remaining: Annotated[Seconds, SEATS]
    phases: Annotated[Indices, SEATS, COLUMNS]
    held: Annotated[Indices, SEATS]
    durations: Annotated[Seconds, COLUMNS]
    pace: Annotated[Floats, SEATS, 2]
    slot_offset: Annotated[Seconds, 1]
    steady: Annotated[Seconds, 1]
    spare_phases: Annotated[Indices, SEATS, COLUMNS]
    spare_results: Annotated[Supports, COLUMNS]

    priorities: Annotated[Floats, SEATS, PARTS]
    """Priority on each body part, >= 0, shape (seats, parts)."""

    patience: Annotated[Seconds, SEATS]
    """Clock time until which a start waits [s], shape (seats,)."""

    late: Annotated[Indices, SEATS]
    """What becomes of it then: `GIVES_UP` or `STARTS_MUTED`, shape (seats,)."""

    target: Annotated[Seconds, SEATS]
    """Clip time at the end of the slot, shape (seats,)."""

    natural: Annotated[Seconds, SEATS]
    """What the slot would last at the clip's own speed [s], shape (seats,)."""

    fade_asked: Annotated[Seconds, SEATS]
    """How long the present fade should take [s], shape (seats,)."""

    fade_elapsed: Annotated[Seconds, SEATS, 2]
    """How long it has taken so far, likewise [s]."""

    levels: Annotated[Weights, SEATS]
    """Activation levels, shape (seats,)."""

    shares: Annotated[Weights, SEATS]
    """Leg weights of those that vote on a duration, shape (seats,)."""

    votes: Annotated[Seconds, SEATS]
    """Their votes [s], shape (seats,)."""
