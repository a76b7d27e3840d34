"""A clip: one body's poses at a steady rate."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from footfall.arrays import Positions, Rotations, frozen
from footfall.errors import ClipError
from footfall.skeleton import Skeleton, world_poses

__all__ = ["Clip"]

FARTHEST = 1e6
"""How far from the origin a body may be [m]: farther away no number tells its feet apart."""


@dataclass(frozen=True, eq=False)
class Clip:
    """Poses of one body at a steady frame rate, frame 0 at time 0.

    A cyclic clip ends on the pose it began with, one cycle's displacement further: its last
    frame *is* its first one, and both are stored.

    Raises:
        ClipError: If there are no frames, shapes disagree with the skeleton, a number is not
            finite, the pelvis is a thousand kilometers away, a quaternion is not of unit length,
            the rate is not positive, or a cyclic clip has a single frame.
    """

    skeleton: Skeleton
    """The body."""

    pelvis_positions: Positions
    """Joint 0 in the world [m], shape (frames, 3)."""

    local_rotations: Rotations
    """Joints relative to their parents, joint 0 relative to the world, (frames, joints, 4)."""

    fps: float
    """Frames per second."""

    cyclic: bool = False
    """Whether it starts over after its last frame, or stays clamped on it."""

    name: str = "clip"
    """What messages and files call it."""

    provenance: tuple[str, ...] = ()
    """Where it comes from and what was done to it, oldest first; one sentence each."""

    def __post_init__(self) -> None:
        positions = frozen(self.pelvis_positions)
        rotations = frozen(self.local_rotations)
        self._check_shapes(positions, rotations)
        if not (self.fps > 0.0 and math.isfinite(self.fps)):
            raise ClipError(f"clip {self.name!r} has {self.fps} frames per second; it must be > 0")
        if self.cyclic and len(positions) < 2:
            raise ClipError(f"clip {self.name!r} is cyclic with a single frame; it needs two")
        for label, array in (("pelvis position", positions), ("rotation", rotations)):
            if not np.isfinite(array).all():
                frame = int(np.argwhere(~np.isfinite(array))[0][0])
                raise ClipError(f"clip {self.name!r}: a {label} in frame {frame} is not finite")
        away = np.abs(positions).max(axis=1)
        if away.max() > FARTHEST:
            frame = int(np.argmax(away > FARTHEST))
            raise ClipError(
                f"clip {self.name!r}: the pelvis in frame {frame} is {away[frame]:g} m away; it "
                f"must be within {FARTHEST:g} m, in meters"
            )
        lengths = np.linalg.norm(rotations, axis=-1)
        if np.abs(lengths - 1.0).max() > 1e-6:
            frame, joint = (int(i) for i in np.argwhere(np.abs(lengths - 1.0) > 1e-6)[0])
            raise ClipError(
                f"clip {self.name!r}: the rotation of {self.skeleton.names[joint]!r} in frame "
                f"{frame} has length {lengths[frame, joint]:.6f}; unit quaternions are needed"
            )
        object.__setattr__(self, "pelvis_positions", positions)
        object.__setattr__(self, "local_rotations", rotations)

    def _check_shapes(self, positions: Positions, rotations: Rotations) -> None:
        frames = len(positions)
        if frames == 0:
            raise ClipError(f"clip {self.name!r} has no frames")
        if positions.shape != (frames, 3):
            raise ClipError(
                f"clip {self.name!r}: pelvis positions of shape {positions.shape}; "
                "(frames, 3) is needed"
            )
        expected = (frames, self.skeleton.count, 4)
        if rotations.shape != expected:
            raise ClipError(
                f"clip {self.name!r}: rotations of shape {rotations.shape}; {frames} frames of "
                f"{self.skeleton.count} joints need {expected}"
            )

    @property
    def frames(self) -> int:
        """How many frames are stored."""
        return len(self.pelvis_positions)

    @property
    def duration(self) -> float:
        """Time from the first to the last frame [s]."""
        return (self.frames - 1) / self.fps

    def world_poses(self) -> tuple[Rotations, Positions]:
        """Return world rotations (frames, joints, 4) and positions (frames, joints, 3) [m]."""
        return world_poses(self.skeleton, self.pelvis_positions, self.local_rotations)

    def ordered_like(self, skeleton: Skeleton) -> Clip:
        """Return the same motion with its joints in the order of a skeleton of its family.

        Raises:
            UnknownNameError: If a joint is not there.
        """
        if self.skeleton.names == skeleton.names:
            return self
        order = self.skeleton.order_of(skeleton)
        return self.evolve(
            skeleton=self.skeleton.ordered_like(skeleton),
            local_rotations=self.local_rotations[:, order],
        )

    def evolve(self, *, because: str | None = None, **changes: object) -> Clip:
        """Return a copy with some fields changed.

        Args:
            because: A sentence that is added to its provenance.
            **changes: Fields and their new values.
        """
        if because is not None:
            changes["provenance"] = (*self.provenance, because)
        return replace(self, **changes)  # type: ignore[arg-type]
