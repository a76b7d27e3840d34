"""Frames kept: what a character did, for files, pictures and reports."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats, Positions, Rotations, Supports, Weights, frozen
from footfall.engine.character import Character
from footfall.engine.record import SEATS
from footfall.engine.state import RUNNING
from footfall.geometry import conjugate, multiply
from footfall.motion import Clip
from footfall.skeleton import BodyPart, Skeleton
from footfall.support import Support

__all__ = ["Recorder", "Recording"]


@dataclass(frozen=True, eq=False)
class Recording:
    """What a character did, frame by frame."""

    skeleton: Skeleton
    """Its body."""

    fps: float
    """Frames per second."""

    actions: tuple[str, ...]
    """Names of its actions, in the order of all arrays over actions."""

    world_positions: Positions
    """Joints [m], shape (frames, joints, 3)."""

    world_rotations: Rotations
    """Joints, shape (frames, joints, 4)."""

    supports: Supports
    """What was commanded to carry the body, values of `Support`, shape (frames,)."""

    shares: Weights
    """Leg weight of each action, the rest being the neutral motion's, (frames, actions)."""

    moving: Flags
    """Whether a leg weight was fading, shape (frames,)."""

    clip_times: Floats
    """Where each clip was [s]; NaN while it did not play. Shape (frames, actions)."""

    rates: Floats
    """Clip time per clock time; NaN while it did not play. Shape (frames, actions)."""

    phases: Floats
    """Absolute index of the phase played; NaN where none is synchronized. (frames, actions)."""

    muted: Flags
    """Whether each action went on without its legs, shape (frames, actions)."""

    foot_offsets: Floats
    """How far footprints moved each foot [m], from where the pose has it over the ground,
    shape (frames, 2)."""

    carried: Positions
    """How far moving surfaces have taken each foot since the beginning [m], (frames, 2, 3)."""

    @property
    def frames(self) -> int:
        """How many frames there are."""
        return len(self.supports)

    @property
    def support_text(self) -> str:
        """One of R L D - a frame."""
        return "".join(Support(int(value)).symbol for value in self.supports).replace("Err", "-")

    def to_clip(self, name: str = "recording") -> Clip:
        """Return the motion as a clip."""
        local = np.array(self.world_rotations)
        for joint in range(1, self.skeleton.count):
            parent = int(self.skeleton.parents[joint])
            local[:, joint] = multiply(
                conjugate(self.world_rotations[:, parent]), self.world_rotations[:, joint]
            )
        local /= np.linalg.norm(local, axis=-1, keepdims=True)
        return Clip(self.skeleton, self.world_positions[:, 0], local, self.fps, name=name)


class Recorder:
    """Keeps the frames of one character."""

    def __init__(self, character: Character, fps: float) -> None:
        """Begin an empty recording of a character that is advanced `fps` times a second."""
        self._character = character
        self._fps = fps
        self._rows: list[tuple[object, ...]] = []

    def keep(self) -> None:
        """Keep the frame that the character shows now."""
        crowd = self._character.crowd
        me = crowd.characters[0]
        count = len(self._character.library.actions)
        shares = np.zeros(count)
        times, rates, phases = (np.full(count, np.nan) for _ in range(3))
        muted = np.zeros(count, dtype=np.bool_)
        moving = False
        for seat in range(SEATS):
            if me["status"][seat] < RUNNING:
                continue
            action = int(me["action"][seat])
            shares[action] += me["weights"][seat, BodyPart.LEGS]
            times[action] = me["clip_time"][seat]
            rates[action] = me["rate"][seat]
            muted[action] |= bool(me["muted"][seat])
            if me["playing"][seat]:
                phases[action] = me["phases"][seat, 0]
            ways = me["fade_progress"][seat, 0], me["priority_progress"][seat, BodyPart.LEGS]
            moving = moving or min(ways) < 1.0
        self._rows.append(
            (
                crowd.world_positions[0].copy(),
                crowd.world_rotations[0].copy(),
                int(me["support"]),
                shares,
                moving,
                times,
                rates,
                phases,
                muted,
                np.linalg.norm(me["foot_offset"], axis=-1),
                me["carried"].copy(),
            )
        )

    def finish(self) -> Recording:
        """Return everything that was kept."""
        columns = list(zip(*self._rows, strict=True))
        arrays = [np.array(column) for column in columns]
        return Recording(
            self._character.skeleton,
            self._fps,
            tuple(action.name for action in self._character.library.actions),
            frozen(arrays[0]),
            frozen(arrays[1]),
            frozen(arrays[2], np.int64),
            frozen(arrays[3]),
            frozen(arrays[4], np.bool_),
            frozen(arrays[5]),
            frozen(arrays[6]),
            frozen(arrays[7]),
            frozen(arrays[8], np.bool_),
            frozen(arrays[9]),
            frozen(arrays[10]),
        )
